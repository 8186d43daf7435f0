#include "native/egl_context.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "gl/caps.hpp"

namespace terrella {
namespace {

EGLDisplay surfaceless_display() {
  const auto get_display =
      reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
  EGLDisplay display = EGL_NO_DISPLAY;
  if (get_display != nullptr) display = get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY) display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
  return display;
}

EGLContext create_context(EGLDisplay display, Api api) {
  eglBindAPI(api == Api::core ? EGL_OPENGL_API : EGL_OPENGL_ES_API);
  const EGLint config_wishes[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE,
                                  api == Api::core ? EGL_OPENGL_BIT : EGL_OPENGL_ES3_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (eglChooseConfig(display, config_wishes, &config, 1, &count) == EGL_FALSE || count == 0) return EGL_NO_CONTEXT;
  const EGLint core[] = {
      EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  const EGLint es[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
  return eglCreateContext(display, config, EGL_NO_CONTEXT, api == Api::core ? core : es);
}

}  // namespace

Result<std::unique_ptr<EglContext>> EglContext::make(Api api) {
  const EGLDisplay display = surfaceless_display();
  if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE) {
    return Failure{"This machine has no EGL, so no picture can be drawn without a window."};
  }
  const EGLContext context = create_context(display, api);
  if (context == EGL_NO_CONTEXT || eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) == EGL_FALSE) {
    return Failure{api == Api::core ? "This machine has no OpenGL 3.3; with --gl es it may have OpenGL ES 3.0."
                                    : "This machine has no OpenGL ES 3.0; with --gl core it may have OpenGL 3.3."};
  }
  std::unique_ptr<EglContext> made(new EglContext(display, context));
  if (!gl::read_caps().float_targets) return Failure{"This machine's OpenGL cannot draw to float textures."};
  gl::set_up_context();
  return made;
}

EglContext::~EglContext() {
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  // The display stays: it is the process's, other contexts may share it.
  eglDestroyContext(display_, context_);
}

}  // namespace terrella
