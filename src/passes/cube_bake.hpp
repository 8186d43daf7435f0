// Fills a cube map by a program, a few rows at a time.
#pragma once

#include <cstdint>

#include "gl/mesh.hpp"
#include "gl/program.hpp"
#include "gl/target.hpp"
#include "gl/texture.hpp"

namespace terrella {

class CubeBake {
 public:
  // Begins anew.
  void restart() { next_row_ = 0; }

  [[nodiscard]] bool done(const gl::CubeMap& map) const { return next_row_ >= rows(map.side()); }
  [[nodiscard]] static int rows(int side) { return 6 * side; }
  [[nodiscard]] int rows_done() const { return next_row_; }

  // Draws up to count further rows with the current program, whose uniforms are set but for "face".
  // Returns the texels drawn.
  std::int64_t advance(gl::Program& program, gl::CubeMap& map, int count);

 private:
  gl::CubeTarget target_;
  gl::FullScreen triangle_;
  int next_row_ = 0;
};

}  // namespace terrella
