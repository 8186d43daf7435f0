// Clouds on a sphere from flow noise (Sandahl 18). The noise is computed into cube maps, one for every step of time; two
// of them are blended while the next is made, a few rows a frame.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "passes/cube_bake.hpp"
#include "passes/frame.hpp"
#include "passes/sphere_meshes.hpp"

namespace terrella {

class CloudsShell {
 public:
  explicit CloudsShell(SphereMeshes& spheres);

  bool ready();

  // Brings the maps up to the frame's time, as far as its effort allows. Needs the scene's uniform block.
  void update(const Frame& frame);

  void bind_maps() const;
  // Weight of the later of the two maps, 0..1.
  [[nodiscard]] double blend() const { return blend_; }

  void draw(const Frame& frame);

  [[nodiscard]] bool settled() const { return !coarse_in_use_; }
  [[nodiscard]] std::int64_t noise_evaluations() const { return noise_evaluations_; }

 private:
  struct Key {
    int seed;
    double frequency, persistence, warp, speed;
    int octaves, texels;
    bool operator==(const Key&) const = default;
  };
  struct Picture {
    std::unique_ptr<gl::CubeMap> map;
    std::optional<std::int64_t> step;
  };

  // The finished picture of a step; null if there is none.
  const Picture* picture_of(std::int64_t step) const;
  // Makes rows of the first picture missing from step on, of three; returns false if none is missing.
  bool advance(const Frame& frame, std::int64_t step, int steps, int rows);
  void bake(const Frame& frame, CubeBake& bake, const gl::CubeMap& map, double seconds, int rows);
  void make_coarse(const Frame& frame);

  SphereMeshes& spheres_;
  gl::Program bake_program_{"clouds/bake", "picture/cube_face"};
  gl::Program draw_program_{"clouds/shell"};
  std::optional<Key> key_;
  std::array<Picture, 3> pictures_;
  CubeBake job_;
  std::optional<std::int64_t> job_step_;
  std::size_t job_picture_ = 0;
  std::unique_ptr<gl::CubeMap> coarse_;
  CubeBake coarse_bake_;
  bool coarse_in_use_ = true;
  const gl::CubeMap* before_ = nullptr;
  const gl::CubeMap* after_ = nullptr;
  double blend_ = 0.0;
  std::int64_t noise_evaluations_ = 0;
};

}  // namespace terrella
