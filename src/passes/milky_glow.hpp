// The glow of the milky band, found once for a sky (planet/milky_band.hpp); only what is in the picture is drawn.
#pragma once

#include <optional>
#include <vector>

#include "gl/late_program.hpp"
#include "gl/mesh.hpp"
#include "passes/frame.hpp"
#include "passes/kept_parts.hpp"
#include "planet/milky_band.hpp"

namespace terrella {

class MilkyGlow {
 public:
  // Whether it can be drawn; as for gl::LateProgram.
  bool ready(bool patient) { return program_.ready(patient); }
  // Finds it anew.
  void set(const Scene& scene);
  // Needs ready, where there is a band.
  void draw(const Frame& frame);
  [[nodiscard]] std::int64_t noise_evaluations() const { return glow_.noise_evaluations; }

 private:
  // Places in glow_.indices of the squares that the picture shows.
  [[nodiscard]] Chosen choose(const Frame& frame) const;

  gl::LateProgram program_{"stars/glow"};
  BandGlow glow_;
  std::vector<glm::vec3> directions_;  // of its vertices, unit
  KeptParts<std::uint32_t> parts_;
  std::optional<gl::Mesh> mesh_;  // none where there is no band
};

}  // namespace terrella
