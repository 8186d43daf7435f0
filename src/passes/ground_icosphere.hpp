// The ground as a displaced icosphere (Sandahl 2022, section 2.1). Heights are computed when a parameter changes: at
// once for a coarse mesh and map, over the following frames for the fine ones. Where only their fineness is to be
// another, what is there is shown until the new is made, and kept, so that to go back takes no time.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "gl/height_texture.hpp"
#include "gl/program_choice.hpp"
#include "gl/uniform_buffer.hpp"
#include "passes/cube_bake.hpp"
#include "passes/ground.hpp"
#include "planet/terrain.hpp"

namespace terrella {

class GroundIcosphere : public GroundPass {
 public:
  explicit GroundIcosphere(SphereMeshes& spheres);

  // Makes the scene's coarse mesh, if it has not, for the next update: work that can be done while programs compile.
  void begin(const Scene& scene, const Needs& needs) override;

  void want(const Needs& needs) override;
  bool ready() override { return bake_program_.ready() && draw_program_.ready(); }

  void update(const Frame& frame) override;
  void bind_map(double level) override;
  [[nodiscard]] double map_texel_angle() const override;
  void draw(const Frame& frame) override;
  [[nodiscard]] std::span<const RadiusRange> ranges() const override { return drawn().ranges; }
  [[nodiscard]] bool settled() const override { return fine_ && fine_->fineness == wanted_; }
  [[nodiscard]] bool is_coarse() const override { return !fine_; }
  [[nodiscard]] std::int64_t noise_evaluations() const override { return noise_evaluations_; }

 private:
  struct Fineness {
    int level = 0, texels = 0;  // of the mesh, and of the map
    bool operator==(const Fineness&) const = default;
  };

  struct Surface {
    int level;
    std::vector<glm::vec3> positions;
    std::vector<RadiusRange> ranges;
    GroupedMesh mesh;
    double tolerance;  // within which its triangles keep to the positions, radii
  };

  // Mesh and map, whole.
  struct Fine {
    Fineness fineness;
    Surface surface;
    std::unique_ptr<gl::CubeMap> map;
  };

  // The same while they are made.
  struct Making {
    Fineness fineness;
    std::vector<glm::vec3> positions;
    std::unique_ptr<gl::CubeMap> map;
    CubeBake bake;
  };

  [[nodiscard]] const Surface& drawn() const { return fine_ ? fine_->surface : *coarse_; }
  [[nodiscard]] gl::CubeMap& drawn_map() const { return fine_ ? *fine_->map : *coarse_map_; }
  Surface make_surface(double tolerance, int level, std::vector<glm::vec3> positions);
  void make_coarse(const Frame& frame);
  void begin_fine();
  void advance_fine(const Frame& frame);
  void finish_fine(const Frame& frame);
  // Makes the scene's map of heights readable, if it has one.
  void bind_heights(const HeightMap* map);
  void bake(const Frame& frame, CubeBake& bake, gl::CubeMap& map, int rows);
  // Computes the vertices from the number made so far up to an end.
  void displace(const Scene& scene, int level, std::size_t end, std::vector<glm::vec3>& positions);

  SphereMeshes& spheres_;
  gl::ProgramChoice bake_program_{"picture/cube_face"};
  std::optional<gl::HeightTexture> heights_;  // of the scene's map
  gl::ProgramChoice draw_program_{"ground/icosphere"};
  gl::UniformBuffer layers_;
  std::optional<f64::Terrain> relief_;
  std::optional<f64::Terrain> begun_relief_;
  std::optional<Surface> begun_;  // coarse, of begun_relief_, not yet drawn
  std::optional<Surface> coarse_;
  std::unique_ptr<gl::CubeMap> coarse_map_;
  CubeBake coarse_bake_;
  Fineness wanted_;
  std::optional<Fine> fine_, former_;  // of relief_
  std::optional<Making> making_;
  std::int64_t noise_evaluations_ = 0;
};

}  // namespace terrella
