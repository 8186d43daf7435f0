// How long the GPU itself takes. Desktop only.
#pragma once

#include <optional>

#include "gl/handle.hpp"

namespace terrella::gl {

namespace detail {
inline GLuint create_query() {
  GLuint n = 0;
  glGenQueries(1, &n);
  return n;
}
inline void delete_query(GLuint n) { glDeleteQueries(1, &n); }
}  // namespace detail

// Whether the current context has queries of time whose answers can be trusted: not those of drivers that draw on the
// CPU, which leave out what is done before a triangle is filled.
bool has_timer();

// Times what is drawn between begin and end: GL_TIME_ELAPSED of OpenGL 3.3, or of EXT_disjoint_timer_query in OpenGL
// ES. Only one may run at a time. Needs a context that has such queries.
class Timer {
 public:
  void begin();
  // Waits for the GPU. Milliseconds; nothing where the GPU was disturbed meanwhile, so that the number says nothing.
  std::optional<double> end();

 private:
  Handle<detail::create_query, detail::delete_query> query_;
};

}  // namespace terrella::gl
