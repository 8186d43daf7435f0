// The page's side of the program: C functions that web/page/planet.mjs calls, and calls back into it.
#include <emscripten.h>
#include <emscripten/html5_webgl.h>

#include <memory>
#include <string>

#include "app/session.hpp"
#include "base/check.hpp"
#include "base/json_text.hpp"
#include "gl/caps.hpp"
#include "planet/real_size.hpp"
#include "scene/description.hpp"
#include "scene/json.hpp"
#include "scene/link.hpp"
#include "scene/manual.hpp"
#include "scene/parameters.hpp"

namespace {

using terrella::has_real_size;
using terrella::Session;

// clang-format off
// A page may hold several canvases, each with a program of its own, which alone knows this name.
EM_JS(void, page_name_canvas, (), { specialHTMLTargets["!planet"] = Module.canvas; });
EM_JS(void, page_scene_changed, (), { Module.onSceneChanged(); });
EM_JS(void, page_copy_text, (const char* text), { Module.onCopyText(UTF8ToString(text)); });
EM_JS(void, page_copy_typed, (const char* text), { Module.onCopyTyped(UTF8ToString(text)); });
EM_JS(void, page_save_json, (const char* text), { Module.onSaveJson(UTF8ToString(text)); });
EM_JS(void, page_open_json, (), { Module.onOpenJson(); });
EM_JS(void, page_save_picture, (int width, int height, int transparent),
      { Module.onSavePicture({ width, height, transparent : transparent !== 0 }); });
EM_JS(int, page_can_fill_screen, (), { return Module.onFillScreen ? 1 : 0; });
EM_JS(void, page_fill_screen, (), { Module.onFillScreen(); });
EM_JS(void, page_want_real_size, (), { Module.onWantRealSize(); });
EM_JS(void, page_keep_habits, (const char* text), { Module.onKeepHabits(UTF8ToString(text)); });
// clang-format on

std::unique_ptr<Session> session;
EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context = 0;

// Text returned to the page lives until the next call.
const char* returned(std::string text) {
  static std::string kept;
  kept = std::move(text);
  return kept.c_str();
}

const char* returned_list(const std::vector<std::string>& sentences) {
  return returned(terrella::json_texts(sentences));
}

}  // namespace

extern "C" {

// From now on draws with the context that the page's canvas has, a new one or one restored. Returns whether it can: not
// without float targets.
EMSCRIPTEN_KEEPALIVE int terrella_start() {
  if (context == 0) {
    EmscriptenWebGLContextAttributes attributes;
    emscripten_webgl_init_context_attributes(&attributes);
    attributes.majorVersion = 2;
    attributes.enableExtensionsByDefault = false;  // thirty questions to the driver; read_caps asks the ones it needs
    page_name_canvas();
    context = emscripten_webgl_create_context("!planet", &attributes);
    CHECK(context > 0, context);
  }
  emscripten_webgl_make_context_current(context);
  if (!terrella::gl::read_caps().float_targets) return 0;
  terrella::gl::set_up_context();
  session->context_made();
  return 1;
}

EMSCRIPTEN_KEEPALIVE void terrella_context_lost() { session->context_lost(); }

EMSCRIPTEN_KEEPALIVE void terrella_resize(int width, int height, double scale, int fingers) {
  session->resize(width, height, scale, fingers != 0);
}

// Returns the share of shaders that are ready, below 1, until there is a picture; then 1, plus 1 if a picture was
// drawn, plus 2 if another frame is wanted, plus 4 if the picture on screen lacks nothing, plus 8 if it is of the air
// alone.
EMSCRIPTEN_KEEPALIVE double terrella_frame(double seconds) {
  const Session::Turn turn = session->frame(seconds, 0);
  if (turn.progress < 1.0) return turn.progress;
  return 1.0 + (turn.drawn ? 1.0 : 0.0) + (turn.again ? 2.0 : 0.0) + (turn.whole ? 4.0 : 0.0) + (turn.bare ? 8.0 : 0.0);
}

EMSCRIPTEN_KEEPALIVE void terrella_pointer_is_finger(int finger) { session->pointer_is_finger(finger != 0); }
EMSCRIPTEN_KEEPALIVE void terrella_pointer_moved(double x, double y) { session->pointer_moved(x, y); }
EMSCRIPTEN_KEEPALIVE void terrella_pointer_button(int button, int down) {
  session->pointer_button(static_cast<terrella::Button>(button), down != 0);
}
EMSCRIPTEN_KEEPALIVE void terrella_pointer_left() { session->pointer_left(); }
EMSCRIPTEN_KEEPALIVE void terrella_wheel(double notches) { session->wheel(notches); }
EMSCRIPTEN_KEEPALIVE void terrella_pinch(double factor, double twist, double dx, double dy, double x, double y) {
  session->pinch(factor, twist, dx, dy, x, y);
}
// key: an index of terrella::Key, in its order. Returns whether it was of use.
EMSCRIPTEN_KEEPALIVE int terrella_key(int key, int down, int shift, int control) {
  return session->key(static_cast<terrella::Key>(key), down != 0, {shift != 0, control != 0}) ? 1 : 0;
}
EMSCRIPTEN_KEEPALIVE void terrella_keys_left() { session->keys_left(); }
EMSCRIPTEN_KEEPALIVE void terrella_text(unsigned codepoint) { session->text(codepoint); }
EMSCRIPTEN_KEEPALIVE int terrella_wants_text() { return session->wants_text() ? 1 : 0; }
EMSCRIPTEN_KEEPALIVE void terrella_pasted(const char* text) { session->pasted(text); }

// JSON of a value, or "" where there is no such parameter.
EMSCRIPTEN_KEEPALIVE const char* terrella_get(const char* path) {
  const terrella::Parameter* parameter = terrella::find_parameter(path);
  if (parameter == nullptr) return returned("");
  return returned(terrella::json_value(parameter->get(session->document().scene)));
}
EMSCRIPTEN_KEEPALIVE const char* terrella_no_such_parameter(const char* path) {
  return returned(terrella::no_such_parameter(path).text());
}
// A sentence, or "".
EMSCRIPTEN_KEEPALIVE const char* terrella_set(const char* path, const char* text) {
  return returned(session->set(path, text));
}
EMSCRIPTEN_KEEPALIVE const char* terrella_scene() { return returned(terrella::to_json(session->document())); }
EMSCRIPTEN_KEEPALIVE const char* terrella_link() { return returned(terrella::to_link(session->document())); }
EMSCRIPTEN_KEEPALIVE const char* terrella_description() { return returned(terrella::description(session->document())); }
EMSCRIPTEN_KEEPALIVE const char* terrella_load_json(const char* text) {
  return returned_list(session->load_json(text));
}
EMSCRIPTEN_KEEPALIVE const char* terrella_load_link(const char* link) {
  return returned_list(session->load_link(link));
}
// A map of heights: pixels of four bytes, or with a height of 0 the bytes of a PFM file, width of them. at_once: the
// scene takes it, else those do that name it. A sentence, or "".
EMSCRIPTEN_KEEPALIVE const char* terrella_take_map(const char* name, const unsigned char* bytes, int width, int height,
                                                   int at_once) {
  const auto map = height == 0 ? terrella::read_pfm_height_map(
                                     name, {reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(width)})
                               : terrella::read_pixels_of_height_map(name, width, height, bytes);
  if (map) at_once != 0 ? session->take_map({name, *map}) : session->know_map({name, *map});
  return returned(map.sentence());
}

// Of the page's two programs the one for miniatures hands over and the other takes over; neither has what only the
// other needs for that.
EMSCRIPTEN_KEEPALIVE int terrella_hands_rest() { return session->hands_rest() ? 1 : 0; }
EMSCRIPTEN_KEEPALIVE const char* terrella_hand_over() { return returned(has_real_size ? "" : session->hand_over()); }
EMSCRIPTEN_KEEPALIVE void terrella_take_over(const char* text) {
  if (has_real_size) session->take_over(text);
}

EMSCRIPTEN_KEEPALIVE void terrella_add_notice(const char* sentence) { session->add_notices({sentence}); }
EMSCRIPTEN_KEEPALIVE void terrella_copy_failed() { session->copy_failed(); }
EMSCRIPTEN_KEEPALIVE void terrella_set_paused(int paused) { session->set_paused(paused != 0); }
EMSCRIPTEN_KEEPALIVE void terrella_show_panel(int shown) { session->show_panel(shown != 0); }
EMSCRIPTEN_KEEPALIVE void terrella_take_habits(const char* text) { session->take_habits(text); }
EMSCRIPTEN_KEEPALIVE const char* terrella_stats() { return returned(session->stats()); }
EMSCRIPTEN_KEEPALIVE void terrella_render(double seconds) { session->render_at(seconds, 0); }

// Four bytes a pixel, top row first, alive until the next picture. transparent: 1 for the planet alone, 0 with its sky.
EMSCRIPTEN_KEEPALIVE const unsigned char* terrella_picture(int width, int height, int transparent) {
  static std::vector<unsigned char> pixels;
  const terrella::Image image = session->picture(width, height, transparent != 0);
  pixels.assign(std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 255);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float* from = image.at(x, y);
      unsigned char* to =
          pixels.data() + std::size_t{4} * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                            static_cast<std::size_t>(x));
      for (int c = 0; c < image.channels; ++c) to[c] = static_cast<unsigned char>(from[c] * 255.0F + 0.5F);
    }
  }
  return pixels.data();
}
EMSCRIPTEN_KEEPALIVE int terrella_largest_picture() { return terrella::largest_picture; }
}

int main() {
  Session::Host host;
  host.scene_changed = page_scene_changed;
  host.copy_text = [](const std::string& text) { page_copy_text(text.c_str()); };
  host.copy_typed = [](const std::string& text) { page_copy_typed(text.c_str()); };
  host.save_json = [](const std::string& text) { page_save_json(text.c_str()); };
  host.open_json = page_open_json;
  host.save_picture = [](const terrella::PictureWish& wish) {
    page_save_picture(wish.width, wish.height, wish.transparent ? 1 : 0);
  };
  if (page_can_fill_screen() != 0) host.fill_screen = page_fill_screen;
  host.want_real_size = page_want_real_size;
  host.keep_habits = [](const std::string& text) { page_keep_habits(text.c_str()); };
  session = std::make_unique<Session>(std::move(host));
  return 0;
}
