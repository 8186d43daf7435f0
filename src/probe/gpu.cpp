#include "probe/gpu.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "base/check.hpp"
#include "gl/caps.hpp"
#include "gl/program.hpp"
#include "gl/target.hpp"

namespace terrella::probe {
namespace {

constexpr std::size_t kWidth = 1024, kMostRows = 2048;  // of the texture of numbers; OpenGL ES 3.0 has at least 2048

constexpr const char* kBefore = R"(
#define Real float
uniform highp sampler2D numbers;
uniform highp sampler2D height_map;
uniform int two;
layout(location = 0) in int start;
out vec4 answers_low;
out vec4 answers_high;
out float finished;
float answers[8];
float num(int i) {
  int at = start + i;
  return texelFetch(numbers, ivec2(at & 1023, at >> 10), 0).x;
}
vec3 triple(int i) { return vec3(num(i), num(i + 1), num(i + 2)); }
uint bits(int i) { return uint(num(i)) * 65536u + uint(num(i + 1)); }
void put(int i, float x) { answers[i] = x; }
void put3(int i, vec3 v) { put(i, v.x); put(i + 1, v.y); put(i + 2, v.z); }
)";

constexpr const char* kMain = R"(
void main() {
  for (int i = 0; i < 8; ++i) answers[i] = 0.0;
)";

// Software rasterizers end all loops of a shader, and of the vertices computed beside it, after 65,536 turns together:
// then a loop of two does not turn at all.
constexpr const char* kAfter = R"(
  int turns = 0;
  for (int i = 0; i < two; ++i) ++turns;
  finished = turns == two ? 1.0 : 0.0;
  answers_low = vec4(answers[0], answers[1], answers[2], answers[3]);
  answers_high = vec4(answers[4], answers[5], answers[6], answers[7]);
  gl_Position = vec4(0.0);
}
)";

void attach(GLuint program, GLenum stage, const std::string& body) {
  const std::string text =
      (gl::caps().es ? "#version 300 es\nprecision highp float;\nprecision highp int;\n" : "#version 330 core\n") +
      body;
  const GLuint shader = glCreateShader(stage);
  const char* texts[] = {text.c_str()};
  glShaderSource(shader, 1, texts, nullptr);
  glCompileShader(shader);
  GLint compiled = GL_FALSE;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  char log[2048] = {};
  glGetShaderInfoLog(shader, sizeof log, nullptr, log);
  CHECK(compiled == GL_TRUE, log);
  glAttachShader(program, shader);
  glDeleteShader(shader);  // lives on as long as it is attached
}

}  // namespace

GLuint Gpu::program_of(std::string_view function) {
  const auto known = programs_.find(function);
  if (known != programs_.end()) return known->second.name();
  gl::ProgramHandle program;
  attach(program.name(), GL_VERTEX_SHADER,
         library_text() + kBefore + std::string(readers_text()) + kMain + std::string(body_text(function)) + kAfter);
  attach(program.name(), GL_FRAGMENT_SHADER, "out vec4 c;\nvoid main() { c = vec4(0.0); }\n");
  const char* outputs[] = {"answers_low", "answers_high", "finished"};
  glTransformFeedbackVaryings(program.name(), 3, outputs, GL_INTERLEAVED_ATTRIBS);
  glLinkProgram(program.name());
  GLint linked = GL_FALSE;
  glGetProgramiv(program.name(), GL_LINK_STATUS, &linked);
  char log[2048] = {};
  glGetProgramInfoLog(program.name(), sizeof log, nullptr, log);
  CHECK(linked == GL_TRUE, function, ": ", log);
  return programs_.emplace(std::string(function), std::move(program)).first->second.name();
}

void Gpu::draw(GLuint program, const Told& all, const std::vector<GLint>& starts, std::vector<Drawn>& drawn) {
  const gl::Target somewhere(1, 1, gl::Format::rgba8,
                             gl::Depth::none);  // a context without a window has nowhere to draw to
  somewhere.begin();
  gl::HeightTexture::keep(height_map_, all.map.get());
  if (height_map_) height_map_->bind(gl::unit_heights);
  const std::size_t rows = (all.numbers.size() + kWidth - 1) / kWidth;
  std::vector<float> texels = all.numbers;
  texels.resize(rows * kWidth);
  const gl::TextureHandle texture;
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, static_cast<GLsizei>(kWidth), static_cast<GLsizei>(rows), 0, GL_RED, GL_FLOAT,
               texels.data());

  const gl::VertexArrayHandle array;
  const gl::BufferHandle buffer, outcome;
  glBindVertexArray(array.name());
  glBindBuffer(GL_ARRAY_BUFFER, buffer.name());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(starts.size() * sizeof(GLint)), starts.data(), GL_STREAM_DRAW);
  glEnableVertexAttribArray(0);
  glVertexAttribIPointer(0, 1, GL_INT, 0, nullptr);
  glBindBuffer(GL_ARRAY_BUFFER, 0);

  const auto bytes = static_cast<GLsizeiptr>(starts.size() * sizeof(Drawn));
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, outcome.name());
  glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, bytes, nullptr, GL_STREAM_READ);
  glUseProgram(program);
  glUniform1i(glGetUniformLocation(program, "numbers"), 0);
  glUniform1i(glGetUniformLocation(program, "height_map"), gl::unit_heights);
  glUniform1i(glGetUniformLocation(program, "two"), 2);
  glEnable(GL_RASTERIZER_DISCARD);
  glBeginTransformFeedback(GL_POINTS);
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(starts.size()));
  glEndTransformFeedback();
  glDisable(GL_RASTERIZER_DISCARD);
  const auto* mapped =
      static_cast<const Drawn*>(glMapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bytes, GL_MAP_READ_BIT));
  CHECK(mapped != nullptr, "the driver hands no answers back");
  drawn.insert(drawn.end(), mapped, mapped + starts.size());
  glUnmapBuffer(GL_TRANSFORM_FEEDBACK_BUFFER);
  glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
  glBindVertexArray(0);
}

std::vector<Answers<float>> Gpu::evaluate(std::string_view function, std::span<const Told> told) {
  const GLuint program = program_of(function);
  std::vector<Drawn> drawn;
  Told together;
  std::vector<GLint> starts;
  for (std::size_t i = 0; i < told.size(); ++i) {
    const std::vector<float>& numbers = told[i].numbers;
    CHECK(numbers.size() <= kWidth * kMostRows, numbers.size());
    starts.push_back(static_cast<GLint>(together.numbers.size()));
    together.numbers.insert(together.numbers.end(), numbers.begin(), numbers.end());
    together.map = told[i].map;
    const bool last = i + 1 == told.size();
    if (last || told[i + 1].map != together.map ||
        together.numbers.size() + told[i + 1].numbers.size() > kWidth * kMostRows) {
      draw(program, together, starts, drawn);
      together = {};
      starts.clear();
    }
  }
  std::vector<Answers<float>> answers;
  for (std::size_t i = 0; i < told.size(); ++i) {
    std::vector<Drawn> alone = {drawn[i]};
    // It may have been one of those beside it that went on for too long.
    if (drawn[i].finished == 0.0F && told.size() > 1) {
      alone.clear();
      draw(program, told[i], {0}, alone);
    }
    if (alone[0].finished == 0.0F) alone[0].answers.fill(std::numeric_limits<float>::quiet_NaN());
    answers.push_back(alone[0].answers);
  }
  return answers;
}

}  // namespace terrella::probe
