#include "window/clipboard.hpp"

#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include "window/patience.hpp"
#include "window/selection.hpp"

namespace terrella::test {

Clipboard::Clipboard(_XDisplay* connection)
    : connection_(connection),
      window_(XCreateSimpleWindow(connection, DefaultRootWindow(connection), 0, 0, 1, 1, 0, 0, 0)),
      clipboard_(XInternAtom(connection, "CLIPBOARD", False)),
      utf8_(XInternAtom(connection, "UTF8_STRING", False)) {}

Clipboard::~Clipboard() { XDestroyWindow(connection_, window_); }

void Clipboard::copy(const std::string& text) {
  text_ = text;
  times_given_ = 0;
  XSetSelectionOwner(connection_, clipboard_, window_, CurrentTime);
  XSync(connection_, False);
}

bool Clipboard::is_own() {
  give();
  return XGetSelectionOwner(connection_, clipboard_) == window_;
}

void Clipboard::give() {
  XEvent event;
  while (XCheckTypedWindowEvent(connection_, window_, SelectionRequest, &event) == True) {
    if (give_selection(event.xselectionrequest, utf8_, text_)) ++times_given_;
  }
}

std::optional<std::string> Clipboard::paste() {
  XConvertSelection(connection_, clipboard_, utf8_, clipboard_, window_, CurrentTime);
  XEvent event = {};
  const bool answered =
      until([&] { return XCheckTypedWindowEvent(connection_, window_, SelectionNotify, &event) == True; });
  if (!answered || event.xselection.property == None) return std::nullopt;
  Atom type = None;
  int bits = 0;
  unsigned long length = 0, left = 0;
  unsigned char* bytes = nullptr;
  constexpr long longest = 1 << 20;
  XGetWindowProperty(connection_, window_, clipboard_, 0, longest, True, utf8_, &type, &bits, &length, &left, &bytes);
  std::optional<std::string> text;
  if (type == utf8_) text.emplace(reinterpret_cast<const char*>(bytes), length);
  XFree(bytes);
  return text;
}

}  // namespace terrella::test
