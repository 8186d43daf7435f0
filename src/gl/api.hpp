// The OpenGL that the whole project speaks: what OpenGL 3.3 core and OpenGL ES 3.0 (and so WebGL 2) share.
#pragma once

#ifdef __EMSCRIPTEN__
#include <GLES3/gl3.h>
#else
#include <epoxy/gl.h>
#endif
