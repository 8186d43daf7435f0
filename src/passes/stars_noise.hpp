// Stars as small squares, found once for a sky (planet/stars.hpp); only those in the picture are drawn. Behind them the
// glow of the milky band.
#pragma once

#include <optional>
#include <vector>

#include "gl/late_program.hpp"
#include "passes/chosen_squares.hpp"
#include "passes/frame.hpp"
#include "passes/milky_glow.hpp"
#include "planet/stars.hpp"

namespace terrella {

class StarsNoise {
 public:
  // Finds the stars once their program is there; no picture waits for it unless it is to be complete.
  void update(const Frame& frame);
  void draw(const Frame& frame);
  [[nodiscard]] bool settled() const { return key_.has_value(); }
  [[nodiscard]] std::int64_t noise_evaluations() const { return noise_evaluations_; }

 private:
  // Places in stars_ of those that the picture shows.
  [[nodiscard]] Chosen choose(const Frame& frame) const;

  struct Key {
    double density, band;
    int seed;
    bool operator==(const Key&) const = default;
  };

  gl::LateProgram program_{"stars/noise"};
  std::optional<Key> key_;  // of the stars found, none before
  std::vector<Star> stars_;
  ChosenSquares squares_{2};
  MilkyGlow glow_;
  std::int64_t noise_evaluations_ = 0;
};

}  // namespace terrella
