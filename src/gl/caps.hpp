// What this machine's OpenGL can do, asked once after a context is made (and again after one was lost).
#pragma once

#include <string>

namespace terrella::gl {

struct Caps {
  bool es = false;                  // OpenGL ES or WebGL, not desktop OpenGL
  bool float_targets = false;       // 16 bit float textures can be drawn to; without them nothing can be drawn here
  bool full_float_targets = false;  // 32 bit ones too
  bool clip_control = false;        // depths can run from 0 to 1 before they are stored, not from -1
  bool parallel_compile = false;    // shaders compile in the background and say when they are done
  int max_texture = 0;              // pixels along a side
};

// Reads the capabilities of the current context.
Caps read_caps();

// Those of the context that read_caps saw last.
const Caps& caps();

// The driver's own name for what draws. To ask for it is to wait until the driver has done all that it was told.
const std::string& renderer_name();

// Sets the state that every pass relies on. Call once for a context.
void set_up_context();

}  // namespace terrella::gl
