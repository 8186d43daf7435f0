// Runs a piece of the shader library on the driver, for many inputs at once, by transform feedback.
#pragma once

#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <glm/vec4.hpp>

#include "base/check.hpp"
#include "gl/api.hpp"
#include "gl/caps.hpp"
#include "gl/program.hpp"
#include "gl/target.hpp"

namespace terrella::test {

// Adds shaders/<path>, after what it includes; each file once.
inline void add_library(const std::string& path, std::set<std::string>& added, std::string& text) {
  if (!added.insert(path).second) return;
  std::ifstream file(std::string(TERRELLA_SOURCE_DIR) + "/shaders/" + path);
  CHECK(file.good(), path);
  const std::string include = "#include \"";
  std::string own;
  for (std::string line; std::getline(file, line);) {
    const bool includes = line.rfind(include, 0) == 0;
    if (includes) add_library(line.substr(include.size(), line.rfind('"') - include.size()), added, text);
    own += includes ? "\n" : line + "\n";
  }
  text += own;
}

// The text of shaders/lib/<name>.glsl with those that it includes in front, each once.
inline std::string library(const std::vector<std::string>& names) {
  std::set<std::string> added;
  std::string text;
  for (const std::string& name : names) add_library("lib/" + name + ".glsl", added, text);
  return text;
}

inline GLuint shader(GLenum stage, const std::string& body) {
  const std::string text =
      (gl::caps().es ? "#version 300 es\nprecision highp float; precision highp int;\n" : "#version 330 core\n") + body;
  const GLuint name = glCreateShader(stage);
  const char* texts[] = {text.c_str()};
  glShaderSource(name, 1, texts, nullptr);
  glCompileShader(name);
  GLint ok = 0;
  glGetShaderiv(name, GL_COMPILE_STATUS, &ok);
  char log[2000] = {};
  glGetShaderInfoLog(name, sizeof log, nullptr, log);
  CHECK(ok == GL_TRUE, log);
  return name;
}

// body computes `vec4 result` from `vec4 a` and `vec4 b`. globals: what is declared before it.
inline std::vector<glm::vec4> run_on_gpu(const std::vector<std::string>& libraries, const std::string& body,
                                         const std::vector<glm::vec4>& inputs /* a, b, a, b, … */,
                                         const std::string& globals = {}) {
  const std::string vertex = library(libraries) + globals +
                             "layout(location = 0) in vec4 a;\nlayout(location = 1) in vec4 b;\nout vec4 outcome;\n"
                             "void main() { vec4 result;\n" +
                             body + "\noutcome = result; gl_Position = vec4(0.0); }\n";
  const GLuint program = glCreateProgram();
  glAttachShader(program, shader(GL_VERTEX_SHADER, vertex));
  glAttachShader(program, shader(GL_FRAGMENT_SHADER, "out vec4 c;\nvoid main() { c = vec4(0.0); }\n"));
  const char* outputs[] = {"outcome"};
  glTransformFeedbackVaryings(program, 1, outputs, GL_INTERLEAVED_ATTRIBS);
  glLinkProgram(program);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  CHECK(linked == GL_TRUE, "link");

  const auto count = static_cast<GLsizei>(inputs.size() / 2);
  GLuint buffers[2] = {}, array = 0;
  glGenBuffers(2, buffers);
  glGenVertexArrays(1, &array);
  glBindVertexArray(array);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(inputs.size() * sizeof(glm::vec4)), inputs.data(),
               GL_STATIC_DRAW);
  for (GLuint i = 0; i < 2; ++i) {
    glEnableVertexAttribArray(i);
    glVertexAttribPointer(i, 4, GL_FLOAT, GL_FALSE, 2 * sizeof(glm::vec4),
                          reinterpret_cast<const void*>(i * sizeof(glm::vec4)));
  }
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  const auto bytes = static_cast<GLsizeiptr>(static_cast<std::size_t>(count) * sizeof(glm::vec4));
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffers[1]);
  glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, bytes, nullptr, GL_STREAM_READ);
  const gl::Target somewhere(1, 1, gl::Format::rgba8,
                             gl::Depth::none);  // a context without a window has nowhere to draw to
  somewhere.begin();
  glUseProgram(program);
  glUniform1i(glGetUniformLocation(program, "height_map"), gl::unit_heights);
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginTransformFeedback(GL_POINTS);
  glDrawArrays(GL_POINTS, 0, count);
  glEndTransformFeedback();
  glDisable(GL_RASTERIZER_DISCARD);
  std::vector<glm::vec4> results(static_cast<std::size_t>(count));
  const void* mapped = glMapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bytes, GL_MAP_READ_BIT);
  CHECK(mapped != nullptr, "map");
  std::copy_n(static_cast<const glm::vec4*>(mapped), count, results.begin());
  glUnmapBuffer(GL_TRANSFORM_FEEDBACK_BUFFER);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
  glDeleteBuffers(2, buffers);
  glDeleteVertexArrays(1, &array);
  glDeleteProgram(program);
  return results;
}

}  // namespace terrella::test
