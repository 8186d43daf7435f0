// What hands do to a session: on the planet, on the panel, on the keys.
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/imgui_input.hpp"
#include "app/session.hpp"
#include "base/text.hpp"

namespace terrella {
namespace {

constexpr double wheel_zoom = 1.18;    // a notch
constexpr double long_ago = 1.0;       // s
constexpr int frames_until_focus = 6;  // a panel that was hidden appears, then a field of it gets the keyboard

}  // namespace

void Session::pointer_moved(double x, double y) {
  const glm::dvec2 moved = to_pixels(glm::dvec2(x, y) - pointer_);
  pointer_ = {x, y};
  imgui_input::move(x * scale_, y * scale_);
  panel_frames_ = std::max(panel_frames_, 2);
  if (drag_ == Drag::turn) camera_.drag(document_.scene, shown_view(), moved);
  if (drag_ == Drag::look) camera_.look(document_.scene, shown_view(), moved);
  if (drag_ != Drag::none) {
    last_drag_time_ = now_;
    scene_was_changed();
  }
}

void Session::pointer_button(Button button, bool down) {
  // A finger comes without having hovered: the panel must know where it is before it presses.
  if (down && panel_shown_ && renderer_) run_panel();
  imgui_input::button(static_cast<int>(button), down);
  panel_frames_ = 3;
  tab_leads_out_ = false;
  if (down) pressed_on_panel_ = panel_shown_ && ImGui::GetIO().WantCaptureMouse;
  if (!down) {
    // Where nothing is drawn any more, the clock of frames stands: the hand has held still before it lets go.
    if (drag_ == Drag::turn) camera_.release(at_rest_ ? long_ago : now_ - last_drag_time_);
    drag_ = Drag::none;
    return;
  }
  if (pressed_on_panel_) {
    on_panel_ = OnPanel::press;
    return;
  }
  history_.begin();
  camera_.hold();
  const bool look = button != Button::left || modifiers_.control || modifiers_.shift;
  drag_ = look ? Drag::look : Drag::turn;
  last_drag_time_ = now_;
}

bool Session::wants_text() const { return panel_shown_ && ImGui::GetIO().WantTextInput; }

void Session::pointer_is_finger(bool finger) { imgui_input::pointer_is_finger(finger); }

void Session::pointer_left() {
  imgui_input::leave();
  panel_frames_ = std::max(panel_frames_, 2);
}

void Session::wheel(double notches) {
  panel_frames_ = 3;
  if (panel_shown_ && ImGui::GetIO().WantCaptureMouse) {
    if (!hand_is_busy()) on_panel_ = OnPanel::wheel;
    imgui_input::wheel(notches);
  } else {
    go_on_by(History::Means::wheel);
    camera_.zoom(std::pow(wheel_zoom, notches), to_pixels(pointer_));
  }
}

void Session::pinch(double factor, double twist, double dx, double dy, double x, double y) {
  if (pressed_on_panel_) return;  // the first finger came down there
  drag_ = Drag::none;
  const glm::dvec2 middle = to_pixels({x, y});
  if (std::isfinite(factor) && factor > 0.0)
    camera_.zoom_now(document_.scene, shown_view(), std::clamp(factor, 0.2, 5.0), middle);
  if (std::isfinite(twist)) camera_.roll(document_.scene, twist);
  camera_.look(document_.scene, shown_view(), to_pixels({dx, dy}));
  scene_was_changed();
}

// While a widget of the panel has the keyboard, these lead from one to the next, and press them.
bool Session::is_for_panel(Key key) const {
  if (wants_text() || typed_ahead_) return true;
  return panel_shown_ && panel_.has_keyboard() && imgui_input::navigates(key);
}

bool Session::lead_into_panel() {
  if (!panel_shown_ || tab_leads_out_) return false;
  panel_.take_keyboard();
  return true;
}

bool Session::key(Key key, bool down, Modifiers modifiers) {
  modifiers_ = modifiers;
  panel_frames_ = 3;
  const bool typing = is_for_panel(key);
  const bool used = key != Key::unknown && (key != Key::tab || typing || (down && lead_into_panel()));
  // Where nothing of the panel has the keyboard, arrows must not wake what had it last.
  const bool for_imgui = typing || !down || !imgui_input::navigates(key) || key == Key::escape;
  const bool pastes = modifiers.control && key == Key::v;  // pasted() follows, with what the clipboard holds now
  if (for_imgui && !pastes) imgui_input::key(key, down, modifiers);
  if (down && !typing && modifiers.control) {
    if (key == Key::z) modifiers.shift ? redo() : undo();
    if (key == Key::y) redo();
  }
  if (down && !typing && !modifiers.control) {
    const bool again = !keys_down_.insert(key).second;  // a key held down repeats
    const bool for_screen = key == Key::f && modifiers.shift;
    if (!for_screen) keys_tapped_.insert(key);
    if (for_screen && !again && host_.fill_screen) host_.fill_screen();
    if (key == Key::space && camera_.mode() != CameraMode::walk) set_paused(!paused_);
    if (key == Key::h) show_panel(!panel_shown_);
    if (key == Key::c) compare(true);
    if (key == Key::n && !again) surprise();
    if (key == Key::one) set_camera_mode(CameraMode::orbit);
    if (key == Key::two) set_camera_mode(CameraMode::fly);
    if (key == Key::three) set_camera_mode(CameraMode::walk);
  } else {
    keys_down_.erase(key);
    if (key == Key::c) compare(false);
  }
  const bool pushed = camera_.pushed();
  update_pushes();
  if (camera_.pushed() && !pushed) go_on_by(History::Means::keys);
  return used;
}

void Session::keys_left() {
  tab_leads_out_ = false;
  keys_down_.clear();
  modifiers_ = {};
  compare(false);
  update_pushes();
}

void Session::compare(bool wanted) {
  if (wanted == comparing_) return;
  comparing_ = wanted;
  planet_stale_ = true;
  panel_frames_ = std::max(panel_frames_, 2);
}

void Session::surprise() {
  if (hand_is_busy()) return;
  history_.begin();
  panel_.surprise(document_);
  scene_was_changed();
}

Scene Session::shown() const {
  if (!comparing_) return quality_.drawn(document_.scene);
  Scene scene = opened_.scene;
  scene.quality.target_ms = document_.scene.quality.target_ms;
  scene.camera = document_.scene.camera;
  scene.camera.altitude *= scene.planet.radius / document_.scene.planet.radius;
  return quality_.drawn(scene);
}

// In the middle of a press, notches and taps belong to it.
void Session::go_on_by(History::Means means) {
  if (!hand_is_busy()) history_.go_on(means, seconds_by_the_clock());
}

// A hand on the panel begins a step only where it changes something: a planet that runs on after a throw would be split
// in two by the click that means to undo it.
void Session::begin_step_of_panel() {
  if (on_panel_ == OnPanel::press) history_.begin();
  if (on_panel_ == OnPanel::wheel) go_on_by(History::Means::wheel);
  on_panel_ = OnPanel::nothing_new;
}

void Session::update_pushes() {
  const auto pressed = [&](Key key) { return keys_down_.count(key) + keys_tapped_.count(key) > 0; };
  const auto held = [&](Key a, Key b) { return pressed(a) || pressed(b) ? 1.0 : 0.0; };
  Push push;
  push.right = held(Key::right, Key::d) - held(Key::left, Key::a);
  push.ahead = held(Key::up, Key::w) - held(Key::down, Key::s);
  push.nearer = held(Key::plus, Key::plus) - held(Key::minus, Key::minus);
  push.turn = held(Key::e, Key::e) - held(Key::q, Key::q);
  push.tilt = held(Key::r, Key::page_up) - held(modifiers_.shift ? Key::page_down : Key::f, Key::page_down);
  // Keys that are for one way to move alone: in the others they would keep frames coming for nothing.
  if (camera_.mode() == CameraMode::fly) push.up = held(Key::t, Key::t) - held(Key::g, Key::g);
  if (camera_.mode() == CameraMode::walk) push.jump = pressed(Key::space);
  push.fast = modifiers_.shift;
  camera_.push(push);
}

// What follows without a hand, as a fall does, is a step of its own to be undone.
void Session::set_camera_mode(CameraMode mode) {
  if (mode == camera_.mode()) return;
  if (!hand_is_busy()) history_.begin();
  camera_.set_mode(mode);
  update_pushes();
  panel_frames_ = 3;
}

void Session::fly_to(const Destination& there) {
  history_.begin();
  camera_.fly_to(document_.scene, there);
  panel_frames_ = 3;
}

void Session::text(unsigned codepoint) {
  const bool typing = wants_text();
  if (typed_ahead_ && !typing) {
    typed_ahead_->push_back(codepoint);
    return;
  }
  panel_frames_ = 3;
  if (typing || (codepoint != '/' && codepoint != '?')) return imgui_input::text(codepoint);
  show_panel(true);
  if (codepoint == '?') panel_.toggle_keys();
  panel_frames_ = frames_until_focus;
  if (codepoint != '/') return;
  panel_.start_search();
  typed_ahead_.emplace();
}

// A panel that was hidden, or frames that are slow, would else give the letters to the planet.
void Session::hand_on_typed_ahead() {
  if (!typed_ahead_) return;
  if (wants_text()) {
    for (const char32_t codepoint : *typed_ahead_) imgui_input::text(codepoint);
    if (!typed_ahead_->empty()) panel_frames_ = std::max(panel_frames_, 3);
  }
  if (wants_text() || !panel_shown_ || panel_frames_ == 0) typed_ahead_.reset();
}

void Session::pasted(const std::string& text) {
  if (wants_text()) {
    clipboard_ = text;
    imgui_input::paste(modifiers_);
    panel_frames_ = 3;
  } else if (text.find('{') != std::string::npos) {
    add_notices(load_json(text));
  } else if (text.find('=') != std::string::npos) {
    add_notices(load_link(text));
  } else {
    add_notices({text_of("What was pasted is no scene, neither as JSON nor as a link: \"", shortened(text), "\".")});
  }
}

}  // namespace terrella
