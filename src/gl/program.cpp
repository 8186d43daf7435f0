#include "gl/program.hpp"

#include "base/check.hpp"
#include "gl/caps.hpp"
#include "gl/shader_sources.hpp"

namespace terrella::gl {
namespace {

constexpr std::string_view core_header = "#version 330 core\n";
constexpr std::string_view es_header =
    "#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n"
    "precision highp samplerCube;\n";

void attach(GLuint program, GLenum stage, const std::string& path) {
  const std::string_view header = caps().es ? es_header : core_header;
  const std::string_view body = shader_source(path);
  const char* texts[] = {header.data(), body.data()};
  const GLint lengths[] = {static_cast<GLint>(header.size()), static_cast<GLint>(body.size())};
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, 2, texts, lengths);
  glCompileShader(shader);
  glAttachShader(program, shader);
  glDeleteShader(shader);  // lives on as long as it is attached
}

std::string shader_logs(GLuint program) {
  GLuint shaders[2] = {};
  GLsizei count = 0;
  glGetAttachedShaders(program, 2, &count, shaders);
  std::string logs;
  for (GLsizei i = 0; i < count; ++i) {
    char log[2048] = {};
    glGetShaderInfoLog(shaders[i], sizeof log, nullptr, log);
    logs += log;
  }
  char log[2048] = {};
  glGetProgramInfoLog(program, sizeof log, nullptr, log);
  return logs + log;
}

void bind_block(GLuint program, const char* name, Block block) {
  const GLuint index = glGetUniformBlockIndex(program, name);
  if (index != GL_INVALID_INDEX) glUniformBlockBinding(program, index, block);
}

}  // namespace

Program::Program(std::string_view name, std::string_view vertex) : listed_(std::string(name)) {
  attach(id(), GL_VERTEX_SHADER, std::string(vertex.empty() ? name : vertex) + ".vert");
  attach(id(), GL_FRAGMENT_SHADER, std::string(name) + ".frag");
  glLinkProgram(id());
}

bool Program::ready() {
  if (linked_) return true;
  if (caps().parallel_compile) {
    const GLenum completion_status = 0x91B1;
    GLint done = GL_FALSE;
    glGetProgramiv(id(), completion_status, &done);
    linked_ = done != GL_FALSE;  // what is left to ask would wait for all other programs: use() asks it
  } else {
    finish();
  }
  return linked_;
}

void Program::use() {
  if (!finished_) finish();
  glUseProgram(id());
}

void Program::finish() {
  GLint linked = GL_FALSE;
  glGetProgramiv(id(), GL_LINK_STATUS, &linked);
  CHECK(linked == GL_TRUE, name(), shader_logs(id()));
  linked_ = true;
  bind_block(id(), "SceneBlock", block_scene);
  bind_block(id(), "FrameBlock", block_frame);
  bind_block(id(), "WaveBlock", block_waves);
  bind_block(id(), "LayerBlock", block_layers);
  bind_block(id(), "NearWaveBlock", block_near_waves);
  bind_block(id(), "MoreWaveBlock", block_more_waves);
  glUseProgram(id());
  set("ground_map", unit_ground);
  set("clouds_map", unit_clouds);
  set("image", unit_image);
  set("node_places", unit_nodes);
  set("node_coarser", unit_nodes + 1);
  set("node_slopes", unit_nodes + 2);
  set("node_coarser_slopes", unit_nodes + 3);
  set("node_shape_slopes", unit_nodes + 4);
  set("node_coarser_shape_slopes", unit_nodes + 5);
  set("node_means", unit_nodes + 6);
  set("height_map", unit_heights);
  set("mirrored_land", unit_mirror);
  set("mirrored_depths", unit_mirror_depths);
  finished_ = true;
}

void Program::set(const char* name, int value) const { glUniform1i(glGetUniformLocation(id(), name), value); }
void Program::set(const char* name, float value) const { glUniform1f(glGetUniformLocation(id(), name), value); }
void Program::set(const char* name, float x, float y) const { glUniform2f(glGetUniformLocation(id(), name), x, y); }
void Program::set(const char* name, float x, float y, float z, float w) const {
  glUniform4f(glGetUniformLocation(id(), name), x, y, z, w);
}

}  // namespace terrella::gl
