// A mouse and an American keyboard, for programs no other than real ones.
#pragma once

#include <initializer_list>
#include <string>

struct _XDisplay;

namespace terrella::test {

class Hands {
 public:
  explicit Hands(_XDisplay* connection) : connection_(connection) {}

  // Places are the screen's.
  void point(int x, int y);
  void press();
  void release();
  void click(int x, int y);

  // Keys by the names that X gives them: down in this order, up in the other one.
  void tap(std::initializer_list<const char*> keys);
  // Small letters and digits.
  void type(const std::string& text);

 private:
  void key(const char* name, bool down);

  _XDisplay* connection_;
};

}  // namespace terrella::test
