#include "window/drop.hpp"

#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <array>

#include "window/patience.hpp"
#include "window/screen.hpp"
#include "window/selection.hpp"

namespace terrella::test {
namespace {

class Source {
 public:
  Source(_XDisplay* connection, ::Window target)
      : connection_(connection),
        target_(target),
        window_(XCreateSimpleWindow(connection, DefaultRootWindow(connection), 0, 0, 1, 1, 0, 0, 0)) {
    XSetSelectionOwner(connection, atom("XdndSelection"), window_, CurrentTime);
  }
  ~Source() { XDestroyWindow(connection_, window_); }
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  void enter() {
    constexpr long version = 5;
    send("XdndEnter", {version << 24, list()});
  }
  void hover(int x, int y) {
    send("XdndPosition", {0, (static_cast<long>(x) << 16) | y, CurrentTime, static_cast<long>(atom("XdndActionCopy"))});
  }
  void drop() { send("XdndDrop", {0, CurrentTime}); }

  // Whether the target answers yes.
  bool hears(const char* message) {
    XEvent event = {};
    return until([&] {
             const bool heard = XCheckTypedWindowEvent(connection_, window_, ClientMessage, &event) == True;
             return heard && event.xclient.message_type == atom(message);
           }) &&
           event.xclient.data.l[1] != 0;  // GLFW says yes with any number
  }

  // Waits until the target asks for the list of files.
  bool give(const std::string& files) {
    XEvent event = {};
    if (!until([&] { return XCheckTypedWindowEvent(connection_, window_, SelectionRequest, &event) == True; }))
      return false;
    return give_selection(event.xselectionrequest, static_cast<Atom>(list()), files);
  }

 private:
  Atom atom(const char* name) const { return XInternAtom(connection_, name, False); }
  long list() const { return static_cast<long>(atom("text/uri-list")); }

  // The protocol's messages begin with the source's window; the rest is given from the second number on.
  void send(const char* message, std::array<long, 4> rest) {
    XEvent event = {};
    event.xclient.type = ClientMessage;
    event.xclient.window = target_;
    event.xclient.message_type = atom(message);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(window_);
    for (std::size_t i = 0; i < rest.size(); ++i) event.xclient.data.l[i + 1] = rest[i];
    XSendEvent(connection_, target_, False, NoEventMask, &event);
    XFlush(connection_);
  }

  _XDisplay* connection_;
  ::Window target_, window_;
};

}  // namespace

bool drop_file(const Screen& screen, const std::string& title, const std::string& path) {
  const auto place = screen.place_of_window(title);
  if (!place) return false;
  Source source(screen.connection(), screen.window(title));
  source.enter();
  source.hover(place->left + place->width / 2, place->top + place->height / 2);
  if (!source.hears("XdndStatus")) return false;
  source.drop();
  return source.give("file://" + path + "\r\n") && source.hears("XdndFinished");
}

}  // namespace terrella::test
