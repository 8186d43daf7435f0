#include "window/hands.hpp"

#include <X11/Xlib.h>
#include <X11/extensions/XTest.h>

#include <iterator>

namespace terrella::test {
namespace {

// Milliseconds before an event of a key. GLFW takes a key that comes down again within 20 for one that repeats.
constexpr unsigned long pace = 25, at_once = 0;

}  // namespace

void Hands::point(int x, int y) {
  XTestFakeMotionEvent(connection_, -1, x, y, at_once);
  XFlush(connection_);
}

void Hands::press() {
  XTestFakeButtonEvent(connection_, 1, True, at_once);
  XFlush(connection_);
}

void Hands::release() {
  XTestFakeButtonEvent(connection_, 1, False, at_once);
  XFlush(connection_);
}

void Hands::click(int x, int y) {
  point(x, y);
  press();
  release();
}

void Hands::tap(std::initializer_list<const char*> keys) {
  for (const char* name : keys) key(name, true);
  for (auto name = std::rbegin(keys); name != std::rend(keys); ++name) key(*name, false);
}

void Hands::type(const std::string& text) {
  for (const char letter : text) tap({std::string(1, letter).c_str()});
}

void Hands::key(const char* name, bool down) {
  const KeyCode code = XKeysymToKeycode(connection_, XStringToKeysym(name));
  XTestFakeKeyEvent(connection_, code, down ? True : False, pace);
  XFlush(connection_);
}

}  // namespace terrella::test
