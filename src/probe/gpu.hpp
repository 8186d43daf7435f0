// The bodies of the probe's functions as the driver computes them.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gl/handle.hpp"
#include "gl/height_texture.hpp"
#include "probe/evaluate.hpp"

namespace terrella::probe {

// What a body is told in single precision.
struct Told {
  std::vector<float> numbers;
  SharedHeightMap map;  // null where the function reads none
};

// Needs a current context, from its making to its end.
class Gpu {
 public:
  // Computes a function many times at once, each time from numbers that its `prepare` made: one draw for as many as
  // read the same map one after the other and fit into a texture of 2 million numbers. No list of numbers is longer
  // than that. Where the driver gave up in the midst of the function's loops, the answers are no numbers.
  std::vector<Answers<float>> evaluate(std::string_view function, std::span<const Told> told);

 private:
  struct Drawn {
    Answers<float> answers;
    float finished;  // 0 where the driver gave up
  };
  // starts: where in the numbers each begins.
  void draw(GLuint program, const Told& all, const std::vector<GLint>& starts, std::vector<Drawn>& drawn);
  GLuint program_of(std::string_view function);

  std::map<std::string, gl::ProgramHandle, std::less<>> programs_;
  std::optional<gl::HeightTexture> height_map_;  // of the draw before
};

// All of shaders/lib as one GLSL text. Defined by cmake/library_embed.cmake.
std::string library_text();

}  // namespace terrella::probe
