// A screen that nobody looks at: an X server of the tests' own, without a window manager.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "base/result.hpp"
#include "window/child.hpp"
#include "window/picture.hpp"

struct _XDisplay;

namespace terrella::test {

class Screen {
 public:
  static constexpr int width = 1280, height = 800;

  // Fails with a sentence where there is no Xvfb.
  static Result<std::unique_ptr<Screen>> open();
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  // For DISPLAY.
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] _XDisplay* connection() const { return connection_; }

  [[nodiscard]] Picture picture() const;

  // The one window of a title that is shown, by X's number; 0 while there is no such window.
  [[nodiscard]] unsigned long window(const std::string& title) const;
  [[nodiscard]] std::optional<Box> place_of_window(const std::string& title) const;
  // As the cross in its frame would.
  void ask_to_close(const std::string& title);

 private:
  Screen(Child server, std::string name, _XDisplay* connection);
  Child server_;
  std::string name_;
  _XDisplay* connection_;
};

}  // namespace terrella::test
