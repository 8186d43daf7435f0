// Clouds on a sphere from flow noise (Sandahl 18). The noise is computed into a cube map for steps of time; two of them
// are blended while the next is made, a few rows a frame. Where the map is to be finer or coarser, the one that is
// there is shown until the new one has caught up.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include <glm/vec3.hpp>

#include "gl/program_choice.hpp"
#include "passes/cube_bake.hpp"
#include "passes/frame.hpp"
#include "passes/sphere_meshes.hpp"

namespace terrella {

class CloudsShell {
 public:
  explicit CloudsShell(SphereMeshes& spheres);

  // Starts to compile the program that the needs call for.
  void want(const Needs& needs);
  bool ready();

  // Brings the map up to the frame's time, as far as its effort allows. Needs the scene's uniform block.
  void update(const Frame& frame);

  void bind_map(double level);
  // Distance of the texels of the map in use, rad.
  [[nodiscard]] double map_texel_angle() const { return texel_angle(shown_->side()); }
  // How the moments in the channels of the map make up the frame's time; their sum is 1.
  [[nodiscard]] const glm::dvec3& moments() const { return moments_; }

  void draw(const Frame& frame);

  [[nodiscard]] bool settled() const { return shown_ != nullptr && shown_ == fine_.map.get(); }
  [[nodiscard]] std::int64_t noise_evaluations() const { return noise_evaluations_; }

 private:
  // What the noise depends on.
  struct Form {
    int seed;
    double frequency, persistence, warp, swirl, belts, speed;
    int octaves;
    bool operator==(const Form&) const = default;
  };
  struct Fineness {
    int octaves = 0, texels = 0;
    double interval = 0.0;  // between steps, s; 0: there is but one

    // How many steps make up a time.
    [[nodiscard]] int blended() const { return interval > 0.0 ? 2 : 1; }
    bool operator==(const Fineness&) const = default;
  };
  struct Map {
    Fineness fineness;
    std::unique_ptr<gl::CubeMap> map;
    // Which step of time each channel holds, once it is finished.
    std::array<std::optional<std::int64_t>, 3> steps{};

    [[nodiscard]] bool holds(std::int64_t step) const;
    // How its channels make up a time, if it holds the steps around it.
    [[nodiscard]] std::optional<glm::dvec3> moments_at(double seconds) const;
    // How they make up the finished step next to it, if there is one.
    [[nodiscard]] std::optional<glm::dvec3> moments_near(double seconds) const;
  };

  static Form form_of(const Scene& scene);
  void begin_map(const Fineness& fineness);
  // Shows what there is while the fine map is behind.
  void stand_in(const Frame& frame);
  // How many rows to make in a frame while the map is behind. interval: between steps, s.
  int hasty_rows(const Frame& frame, double interval);
  // Makes rows of the first step missing from step on; returns false if none of the next few is missing.
  bool advance(const Frame& frame, std::int64_t step, int steps, int rows);
  void bake(const Frame& frame, CubeBake& bake, gl::CubeMap& map, double seconds, int rows);
  // They stay with the program until the scene changes.
  void set_cyclones(const Scene& scene);
  void make_coarse(const Frame& frame);

  SphereMeshes& spheres_;
  gl::Program bake_program_{"clouds/bake", "picture/cube_face"};
  gl::ProgramChoice draw_program_{"clouds/shell"};
  std::optional<Form> form_;
  Map fine_, former_;  // of form_
  std::unique_ptr<gl::CubeMap> coarse_;
  CubeBake job_, coarse_bake_;
  std::optional<std::int64_t> job_step_;
  gl::CubeMap* shown_ = nullptr;  // by the last update
  double last_seconds_ = 0.0;     // time of the last frame that found the map behind
  glm::dvec3 moments_{1.0, 0.0, 0.0};
  std::int64_t noise_evaluations_ = 0;
};

}  // namespace terrella
