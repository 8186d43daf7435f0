#include "native/window.hpp"

#define GLFW_INCLUDE_NONE  // the session has brought OpenGL along
#include <GLFW/glfw3.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/file.hpp"
#include "base/text.hpp"
#include "gl/caps.hpp"
#include "native/kept_habits.hpp"
#include "native/new_file.hpp"
#include "native/window_keys.hpp"
#include "scene/json.hpp"

namespace terrella {
namespace {

constexpr int first_width = 1280, first_height = 720;
constexpr double patience = 0.002;  // s between looks at shaders that compile and at bands that are drawn

// GLFW's own words on what went wrong last.
std::string glfw_complaint() {
  const char* words = nullptr;
  glfwGetError(&words);
  return words == nullptr ? std::string("it does not say why") : shortened(words, 200);
}

void ask_for_core_context() {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);  // macOS has no other
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  // The renderer has its own targets; the window's framebuffer only takes the finished picture.
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
}

// The one that shows a place of the desktop, else the first; none where there is no monitor at all.
GLFWmonitor* monitor_under(int x, int y) {
  int count = 0;
  GLFWmonitor** const monitors = glfwGetMonitors(&count);
  for (int i = 0; i < count; ++i) {
    int left = 0, top = 0;
    glfwGetMonitorPos(monitors[i], &left, &top);
    const GLFWvidmode* const mode = glfwGetVideoMode(monitors[i]);
    if (mode == nullptr) continue;
    if (x >= left && x < left + mode->width && y >= top && y < top + mode->height) return monitors[i];
  }
  return glfwGetPrimaryMonitor();
}

Window& window_of(GLFWwindow* handle) { return *static_cast<Window*>(glfwGetWindowUserPointer(handle)); }

}  // namespace

void Window::Close::operator()(GLFWwindow* window) const {
  glfwDestroyWindow(window);
  glfwTerminate();
}

Result<std::unique_ptr<Window>> Window::open() {
  if (glfwInit() == GLFW_FALSE) return Failure{text_of("No window can be opened here: ", glfw_complaint(), '.')};
  ask_for_core_context();
  Handle handle(glfwCreateWindow(first_width, first_height, "Terrella", nullptr, nullptr));
  if (!handle) {
    const std::string complaint = glfw_complaint();
    glfwTerminate();
    return Failure{text_of("No window with OpenGL 3.3 can be opened here: ", complaint, '.')};
  }
  glfwMakeContextCurrent(handle.get());
  glfwSwapInterval(1);
  if (!gl::read_caps().float_targets) return Failure{"This machine's OpenGL cannot draw to float textures."};
  gl::set_up_context();
  return std::unique_ptr<Window>(new Window(std::move(handle)));
}

Window::Window(Handle handle) : handle_(std::move(handle)), habits_path_(terrella::habits_path()), session_(host()) {
  session_.take_habits(kept_habits(habits_path_));
  session_.context_made();
  glfwSetWindowUserPointer(handle_.get(), this);
  listen_to_hands();
  listen_to_window();
  measure();
}

void Window::run(const SceneDocument& document) {
  session_.know_map(document.scene.terrain.map);
  session_.load_json(to_json(document));
  while (glfwWindowShouldClose(handle_.get()) == GLFW_FALSE) {
    const Session::Turn turn = session_.frame(glfwGetTime(), 0);
    if (turn.drawn) glfwSwapBuffers(handle_.get());
    if (picture_wanted_) save_picture();
    if (screen_wanted_) fill_screen();
    if (turn.drawn && turn.again) {
      glfwPollEvents();
    } else if (turn.again) {
      glfwWaitEventsTimeout(patience);
    } else {
      glfwWaitEvents();
    }
  }
}

Session::Host Window::host() {
  Session::Host host;
  host.copy_text = [this](const std::string& text) { glfwSetClipboardString(handle_.get(), text.c_str()); };
  host.copy_typed = host.copy_text;
  host.save_json = [this](const std::string& text) { tell(save_new_file("planet", ".json", text + "\n")); };
  host.open_json = [this] {
    session_.add_notices({"To open a scene or a map of heights, drag its JSON, PNG or PFM file into this window."});
  };
  host.keep_habits = [this](const std::string& habits) { terrella::keep_habits(habits_path_, habits); };
  // Asked for in the middle of a frame; done after it.
  host.fill_screen = [this] { screen_wanted_ = true; };
  host.save_picture = [this](const PictureWish& wish) { picture_wanted_ = wish; };
  return host;
}

void Window::listen_to_hands() {
  GLFWwindow* const window = handle_.get();
  glfwSetCursorPosCallback(window, [](GLFWwindow* handle, double x, double y) {
    Window& self = window_of(handle);
    self.session_.pointer_moved(x * self.points_per_unit_, y * self.points_per_unit_);
  });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* handle, int button, int action, int) {
    if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
    Window& self = window_of(handle);
    self.buttons_down_ += action == GLFW_PRESS ? 1 : -1;
    self.session_.pointer_button(static_cast<Button>(button), action == GLFW_PRESS);
  });
  glfwSetCursorEnterCallback(window, [](GLFWwindow* handle, int entered) {
    Window& self = window_of(handle);
    // A drag goes on outside.
    if (entered == GLFW_FALSE && self.buttons_down_ == 0) self.session_.pointer_left();
  });
  glfwSetScrollCallback(window, [](GLFWwindow* handle, double, double y) { window_of(handle).session_.wheel(y); });
  glfwSetKeyCallback(window,
                     [](GLFWwindow* handle, int code, int, int action, int) { window_of(handle).key(code, action); });
  glfwSetCharCallback(window,
                      [](GLFWwindow* handle, unsigned codepoint) { window_of(handle).session_.text(codepoint); });
}

void Window::listen_to_window() {
  GLFWwindow* const window = handle_.get();
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* handle, int, int) { window_of(handle).measure(); });
  glfwSetWindowContentScaleCallback(window, [](GLFWwindow* handle, float, float) { window_of(handle).measure(); });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* handle) { window_of(handle).measure(); });
  glfwSetDropCallback(window, [](GLFWwindow* handle, int count, const char** paths) {
    for (int i = 0; i < count; ++i) window_of(handle).open_file(paths[i]);
  });
}

// Tells the session the size of the window; it draws anew.
void Window::measure() {
  int width = 0, height = 0, units = 0, ignored = 0;
  float scale = 1.0F;
  glfwGetFramebufferSize(handle_.get(), &width, &height);
  glfwGetWindowSize(handle_.get(), &units, &ignored);
  glfwGetWindowContentScale(handle_.get(), &scale, nullptr);
  if (width == 0 || height == 0 || units == 0) return;  // minimised
  const auto points = [&](int pixels) {
    return std::max(1, static_cast<int>(pixels / static_cast<double>(scale) + 0.5));
  };
  points_per_unit_ = static_cast<double>(width) / scale / units;
  session_.resize(points(width), points(height), scale);
}

void Window::key(int code, int action) {
  const auto held = [&](int left, int right) {
    return glfwGetKey(handle_.get(), left) == GLFW_PRESS || glfwGetKey(handle_.get(), right) == GLFW_PRESS;
  };
  const Modifiers modifiers{held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT),
                            held(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL)};
  if (modifiers.control) code = printed_key(code);
  if (modifiers.control && code == GLFW_KEY_V) {
    const char* text = action == GLFW_PRESS ? glfwGetClipboardString(handle_.get()) : nullptr;
    if (text != nullptr) session_.pasted(text);
    return;
  }
  session_.key(key_of_glfw(code), action != GLFW_RELEASE, modifiers);
}

// Or back to where it was.
void Window::fill_screen() {
  screen_wanted_ = false;
  GLFWwindow* const window = handle_.get();
  if (glfwGetWindowMonitor(window) != nullptr) {
    glfwSetWindowMonitor(window, nullptr, windowed_.x, windowed_.y, windowed_.width, windowed_.height, GLFW_DONT_CARE);
    return;
  }
  glfwGetWindowPos(window, &windowed_.x, &windowed_.y);
  glfwGetWindowSize(window, &windowed_.width, &windowed_.height);
  GLFWmonitor* const monitor = monitor_under(windowed_.x + windowed_.width / 2, windowed_.y + windowed_.height / 2);
  const GLFWvidmode* const mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
  if (mode != nullptr) glfwSetWindowMonitor(window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void Window::open_file(const std::string& path) {
  const Result<std::string> bytes = read_file(path, largest_map_file);
  if (!bytes) return session_.add_notices({bytes.sentence()});
  if (!is_height_map(*bytes)) return session_.add_notices(session_.load_json(*bytes));
  const std::string name = std::filesystem::path(path).filename().string();
  const Result<SharedHeightMap> map = read_height_map(name, *bytes);
  if (!map) return session_.add_notices({map.sentence()});
  session_.take_map({name, *map});
}

void Window::save_picture() {
  const PictureWish wish = *std::exchange(picture_wanted_, std::nullopt);
  const Image picture = session_.picture(wish.width, wish.height, wish.transparent);
  tell(save_new_file("planet", ".png", encode_png(picture)));
}

void Window::tell(const Result<std::string>& saved) {
  session_.add_notices({saved ? text_of("Saved as ", *saved, '.') : saved.sentence()});
}

}  // namespace terrella
