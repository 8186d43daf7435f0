// A window with a planet in it: GLFW's events to the session, the session's pictures to the screen.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/session.hpp"
#include "base/result.hpp"
#include "scene/document.hpp"

struct GLFWwindow;

namespace terrella {

class Window {
 public:
  // Opens the window and makes its context current. Fails with a sentence where there is no display, or no OpenGL that
  // can draw a planet.
  static Result<std::unique_ptr<Window>> open();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  // Shows a scene until the user closes the window.
  void run(const SceneDocument& document);

 private:
  struct Close {
    void operator()(GLFWwindow* window) const;
  };
  using Handle = std::unique_ptr<GLFWwindow, Close>;

  explicit Window(Handle handle);
  Session::Host host();
  void listen_to_hands();
  void listen_to_window();
  void measure();
  void key(int code, int action);
  void open_file(const std::string& path);
  void save_picture();
  void fill_screen();
  // Tells where a file was saved, or why not.
  void tell(const Result<std::string>& saved);

  Handle handle_;
  std::string habits_path_;  // empty: they are not kept
  Session session_;
  double points_per_unit_ = 1.0;  // GLFW's unit of places is a point on some systems, a pixel on others
  int buttons_down_ = 0;
  std::optional<PictureWish> picture_wanted_;
  bool screen_wanted_ = false;
  struct {
    int x = 0, y = 0, width = 0, height = 0;
  } windowed_;  // its place before it filled the screen, in GLFW's unit
};

}  // namespace terrella
