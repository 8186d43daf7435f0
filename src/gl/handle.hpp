// Owning names of OpenGL objects: made once, moved, deleted with their owner. Needs a current context.
#pragma once

#include <utility>

#include "gl/api.hpp"

namespace terrella::gl {

template <auto Create, auto Delete>
class Handle {
 public:
  Handle() : name_(Create()) {}
  ~Handle() { release(); }
  Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0U)) {}
  Handle& operator=(Handle&& other) noexcept {
    if (this != &other) {
      release();
      name_ = std::exchange(other.name_, 0U);
    }
    return *this;
  }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;

  [[nodiscard]] GLuint name() const { return name_; }

 private:
  void release() {
    if (name_ != 0U) Delete(name_);
    name_ = 0U;
  }

  GLuint name_;
};

namespace detail {
inline GLuint create_buffer() {
  GLuint n = 0;
  glGenBuffers(1, &n);
  return n;
}
inline void delete_buffer(GLuint n) { glDeleteBuffers(1, &n); }
inline GLuint create_vertex_array() {
  GLuint n = 0;
  glGenVertexArrays(1, &n);
  return n;
}
inline void delete_vertex_array(GLuint n) { glDeleteVertexArrays(1, &n); }
inline GLuint create_texture() {
  GLuint n = 0;
  glGenTextures(1, &n);
  return n;
}
inline void delete_texture(GLuint n) { glDeleteTextures(1, &n); }
inline GLuint create_framebuffer() {
  GLuint n = 0;
  glGenFramebuffers(1, &n);
  return n;
}
inline void delete_framebuffer(GLuint n) { glDeleteFramebuffers(1, &n); }
inline GLuint create_renderbuffer() {
  GLuint n = 0;
  glGenRenderbuffers(1, &n);
  return n;
}
inline void delete_renderbuffer(GLuint n) { glDeleteRenderbuffers(1, &n); }
inline GLuint create_program() { return glCreateProgram(); }
inline void delete_program(GLuint n) { glDeleteProgram(n); }
}  // namespace detail

using BufferHandle = Handle<detail::create_buffer, detail::delete_buffer>;
using VertexArrayHandle = Handle<detail::create_vertex_array, detail::delete_vertex_array>;
using TextureHandle = Handle<detail::create_texture, detail::delete_texture>;
using FramebufferHandle = Handle<detail::create_framebuffer, detail::delete_framebuffer>;
using RenderbufferHandle = Handle<detail::create_renderbuffer, detail::delete_renderbuffer>;
using ProgramHandle = Handle<detail::create_program, detail::delete_program>;

}  // namespace terrella::gl
