// The ground as a displaced icosphere (Sandahl 2022, section 2.1). Heights are computed when a parameter changes: at
// once for a coarse mesh and map, over the following frames for the fine ones.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "gl/program_choice.hpp"
#include "gl/uniform_buffer.hpp"
#include "passes/cube_bake.hpp"
#include "passes/frame.hpp"
#include "passes/sphere_meshes.hpp"

namespace terrella {

class GroundIcosphere {
 public:
  explicit GroundIcosphere(SphereMeshes& spheres);

  // Makes the scene's coarse mesh, if it has not, for the next update: work that can be done while programs compile.
  void begin(const Scene& scene, const Needs& needs);

  // Starts to compile the programs that the needs call for.
  void want(const Needs& needs);
  // True once drawing will not wait for them.
  bool ready() { return bake_program_.ready() && draw_program_.ready(); }

  // Brings mesh and map up to date, as far as the frame's effort allows. Needs the scene's uniform block.
  void update(const Frame& frame);

  // Makes the map readable by all passes. level: of its mipmap that they read.
  void bind_map(double level);
  // Distance of the texels of the map in use, rad.
  [[nodiscard]] double map_texel_angle() const;

  void draw(const Frame& frame);
  // Where the surface lies that is drawn, over each group of the icosphere.
  [[nodiscard]] std::span<const RadiusRange> ranges() const { return drawn().ranges; }

  // Whether nothing finer is still to come.
  [[nodiscard]] bool settled() const { return fine_done_; }
  // Noise evaluated by the last update.
  [[nodiscard]] std::int64_t noise_evaluations() const { return noise_evaluations_; }

 private:
  // What the heights depend on.
  struct Key {
    decltype(Scene::planet) planet;
    decltype(Scene::terrain) terrain;
    double water_level, ice_latitude;
    int level, texels;
    bool operator==(const Key&) const = default;
  };

  struct Surface {
    int level;
    std::vector<glm::vec3> positions;
    std::vector<RadiusRange> ranges;
    GroupedMesh mesh;
    double tolerance;  // within which its triangles keep to the positions, radii
  };

  static Key key_of(const Scene& scene, const Needs& needs);
  [[nodiscard]] const Surface& drawn() const { return fine_done_ ? *fine_ : *coarse_; }
  Surface make_surface(double tolerance, int level, std::vector<glm::vec3> positions);
  void make_coarse(const Frame& frame);
  void advance_fine(const Frame& frame);
  void bake(const Frame& frame, CubeBake& bake, gl::CubeMap& map, int rows);
  // Computes the vertices from the number made so far up to an end.
  void displace(const Scene& scene, int level, std::size_t end, std::vector<glm::vec3>& positions);

  SphereMeshes& spheres_;
  gl::Program bake_program_{"ground/bake", "picture/cube_face"};
  gl::ProgramChoice draw_program_{"ground/icosphere"};
  gl::UniformBuffer layers_;
  std::optional<Key> key_;
  std::optional<Surface> coarse_, fine_;
  std::optional<Key> begun_key_;
  std::optional<Surface> begun_;  // coarse, of begun_key_, not yet drawn
  std::unique_ptr<gl::CubeMap> coarse_map_, fine_map_;
  CubeBake coarse_bake_, fine_bake_;
  std::vector<glm::vec3> fine_positions_;
  bool coarse_done_ = false;
  bool fine_done_ = false;
  std::int64_t noise_evaluations_ = 0;
};

}  // namespace terrella
