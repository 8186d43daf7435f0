#include "gl/caps.hpp"

#include <cstring>

#include "gl/api.hpp"

#ifdef __EMSCRIPTEN__
#include <emscripten.h>
#include <emscripten/html5_webgl.h>
#endif

namespace terrella::gl {
namespace {

Caps current;
std::string name_of_renderer;  // empty until it is asked for

bool has_extension(const char* name) {
#ifdef __EMSCRIPTEN__
  return emscripten_webgl_enable_extension(emscripten_webgl_get_current_context(), name) != 0;
#else
  GLint count = 0;
  glGetIntegerv(GL_NUM_EXTENSIONS, &count);
  for (GLint i = 0; i < count; ++i) {
    const auto* entry = reinterpret_cast<const char*>(glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i)));
    if (std::strcmp(entry + std::strlen("GL_"), name) == 0) return true;
  }
  return false;
#endif
}

std::string text_of(GLenum what) {
  const auto* text = reinterpret_cast<const char*>(glGetString(what));
  return text == nullptr ? "" : text;
}

// Depths from 0 to 1.
void set_clip_control() {
#ifdef __EMSCRIPTEN__
  EM_ASM({
    const clip = GLctx.getExtension('EXT_clip_control');
    clip['clipControlEXT'](clip['LOWER_LEFT_EXT'], clip['ZERO_TO_ONE_EXT']);
  });
#else
  current.es ? glClipControlEXT(GL_LOWER_LEFT_EXT, GL_ZERO_TO_ONE_EXT) : glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
#endif
}

}  // namespace

Caps read_caps() {
  current = Caps{};
  name_of_renderer.clear();
#ifdef __EMSCRIPTEN__
  current.es = true;
#else
  current.es = text_of(GL_VERSION).rfind("OpenGL ES", 0) == 0;
#endif
  const bool both = has_extension("EXT_color_buffer_float");
  current.full_float_targets = !current.es || both;
  current.float_targets = current.full_float_targets || has_extension("EXT_color_buffer_half_float");
  current.parallel_compile = has_extension("KHR_parallel_shader_compile");
  current.clip_control = has_extension(current.es ? "EXT_clip_control" : "ARB_clip_control");
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &current.max_texture);
  return current;
}

const Caps& caps() { return current; }

const std::string& renderer_name() {
  if (!name_of_renderer.empty()) return name_of_renderer;
  name_of_renderer = text_of(GL_RENDERER);
#ifdef __EMSCRIPTEN__
  if (has_extension("WEBGL_debug_renderer_info")) {
    const GLenum unmasked_renderer = 0x9246;
    name_of_renderer = text_of(unmasked_renderer);
  }
#endif
  return name_of_renderer;
}

void set_up_context() {
#ifndef __EMSCRIPTEN__
  if (!current.es) {
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
  }
#endif
  if (current.clip_control) set_clip_control();
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
}

}  // namespace terrella::gl
