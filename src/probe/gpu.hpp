// The bodies of the probe's functions as the driver computes them.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "gl/handle.hpp"
#include "probe/evaluate.hpp"

namespace terrella::probe {

// Needs a current context, from its making to its end.
class Gpu {
 public:
  // Computes a function for many lists of numbers at once, each list what its `prepare` made: one draw for as many as
  // fit into a texture of 2 million numbers. One list holds no more than that. Where the driver gave up in the midst of
  // the function's loops, the answers are no numbers.
  std::vector<Answers<float>> evaluate(std::string_view function, const std::vector<std::vector<float>>& lists);

 private:
  struct Drawn {
    Answers<float> answers;
    float finished;  // 0 where the driver gave up
  };
  void draw(GLuint program, const std::vector<float>& numbers, const std::vector<GLint>& starts,
            std::vector<Drawn>& drawn);
  GLuint program_of(std::string_view function);

  std::map<std::string, gl::ProgramHandle, std::less<>> programs_;
};

// All of shaders/lib as one GLSL text. Defined by cmake/library_embed.cmake.
std::string library_text();

}  // namespace terrella::probe
