#include "passes/cube_bake.hpp"

#include <algorithm>

namespace terrella {

std::int64_t CubeBake::advance(gl::Program& program, gl::CubeMap& map, int count) {
  const int side = map.side();
  const int end = std::min(next_row_ + std::max(count, 1), rows(side));
  std::int64_t texels = 0;
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  while (next_row_ < end) {
    const int face = next_row_ / side;
    const int first = next_row_ % side;
    const int last = std::min(side, first + end - next_row_);
    program.set("face", face);
    target_.begin(map, face, first, last);
    triangle_.draw();
    texels += std::int64_t{last - first} * side;
    next_row_ += last - first;
  }
  gl::CubeTarget::end();
  map.changed();
  return texels;
}

}  // namespace terrella
