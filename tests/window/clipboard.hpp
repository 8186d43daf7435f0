// The other program at a clipboard.
#pragma once

#include <optional>
#include <string>

struct _XDisplay;

namespace terrella::test {

class Clipboard {
 public:
  explicit Clipboard(_XDisplay* connection);
  ~Clipboard();
  Clipboard(const Clipboard&) = delete;
  Clipboard& operator=(const Clipboard&) = delete;

  void copy(const std::string& text);
  // Whether others have copied nothing since. Hands the text to whoever has asked for it: to be called until they had
  // it.
  bool is_own();
  // The text that somebody else has copied; nothing if nobody has, or does not give it.
  std::optional<std::string> paste();
  // How many times others were given the text of copy().
  [[nodiscard]] int times_given() const { return times_given_; }

 private:
  void give();

  _XDisplay* connection_;
  unsigned long window_;  // to which X tells what happens to the clipboard
  unsigned long clipboard_, utf8_;
  std::string text_;
  int times_given_ = 0;
};

}  // namespace terrella::test
