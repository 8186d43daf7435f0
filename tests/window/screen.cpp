#include "window/screen.hpp"

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <poll.h>
#include <unistd.h>

#include <cstring>
#include <utility>

#include "base/text.hpp"
#include "window/patience.hpp"

namespace terrella::test {
namespace {

// The number of the display that the server has found free; empty if it does not say.
std::string told_number(int pipe) {
  std::string number;
  const int limit = static_cast<int>(std::chrono::milliseconds(patience).count());
  for (char letter = 0; letter != '\n';) {
    pollfd ready{pipe, POLLIN, 0};
    if (poll(&ready, 1, limit) != 1 || read(pipe, &letter, 1) != 1) return {};
    if (letter != '\n') number += letter;
  }
  return number;
}

}  // namespace

Result<std::unique_ptr<Screen>> Screen::open() {
  int number[2];
  if (pipe(number) != 0) return Failure{"No pipe can be made."};
  auto server = Child::start({{"Xvfb", "-displayfd", text_of(number[1]), "-screen", "0",
                               text_of(width, 'x', height, "x24"), "-nolisten", "tcp", "-noreset"},
                              {},
                              ".",
                              "/dev/null"});  // it complains of names of keys that it doesn't know
  close(number[1]);
  const std::string told = server ? told_number(number[0]) : std::string();
  close(number[0]);
  if (!server) return Failure{text_of(server.sentence(), " scripts/setup.sh test installs it.")};
  if (told.empty()) return Failure{"Xvfb does not begin to work."};
  const std::string name = ':' + told;
  _XDisplay* const connection = XOpenDisplay(name.c_str());
  if (connection == nullptr) return Failure{text_of("Xvfb does not answer as display ", name, '.')};
  // By itself, Xlib would end the tests because of a window that goes while it is asked about.
  XSetErrorHandler([](_XDisplay*, XErrorEvent*) { return 0; });
  return std::unique_ptr<Screen>(new Screen(std::move(*server), name, connection));
}

Screen::Screen(Child server, std::string name, _XDisplay* connection)
    : server_(std::move(server)), name_(std::move(name)), connection_(connection) {}

Screen::~Screen() { XCloseDisplay(connection_); }

Picture Screen::picture() const {
  XImage* const image = XGetImage(connection_, DefaultRootWindow(connection_), 0, 0, width, height, AllPlanes, ZPixmap);
  Picture picture{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) picture.pixels.push_back(static_cast<std::uint32_t>(XGetPixel(image, x, y)));
  }
  XDestroyImage(image);
  return picture;
}

unsigned long Screen::window(const std::string& title) const {
  ::Window root = 0, parent = 0, *windows = nullptr;
  unsigned count = 0;
  if (XQueryTree(connection_, DefaultRootWindow(connection_), &root, &parent, &windows, &count) == 0) return 0;
  ::Window found = 0;
  for (unsigned i = 0; i < count && found == 0; ++i) {
    XWindowAttributes attributes;
    char* name = nullptr;
    const bool shown =
        XGetWindowAttributes(connection_, windows[i], &attributes) != 0 && attributes.map_state == IsViewable;
    if (shown && XFetchName(connection_, windows[i], &name) != 0 && title == name) found = windows[i];
    XFree(name);
  }
  XFree(windows);
  return found;
}

std::optional<Box> Screen::place_of_window(const std::string& title) const {
  const ::Window found = window(title);
  XWindowAttributes attributes;
  if (found == 0 || XGetWindowAttributes(connection_, found, &attributes) == 0) return std::nullopt;
  return Box{attributes.x, attributes.y, attributes.width, attributes.height};
}

void Screen::ask_to_close(const std::string& title) {
  XEvent event = {};
  event.xclient.type = ClientMessage;
  event.xclient.window = window(title);
  event.xclient.message_type = XInternAtom(connection_, "WM_PROTOCOLS", False);
  event.xclient.format = 32;
  event.xclient.data.l[0] = static_cast<long>(XInternAtom(connection_, "WM_DELETE_WINDOW", False));
  event.xclient.data.l[1] = CurrentTime;
  XSendEvent(connection_, event.xclient.window, False, NoEventMask, &event);
  XFlush(connection_);
}

}  // namespace terrella::test
