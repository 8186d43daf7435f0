// Stars as small squares, found once for a sky (planet/stars.hpp).
#pragma once

#include <memory>
#include <optional>

#include "gl/mesh.hpp"
#include "gl/program.hpp"
#include "passes/frame.hpp"

namespace terrella {

class StarsNoise {
 public:
  bool ready() { return program_.ready(); }
  void update(const Frame& frame);
  void draw(const Frame& frame);
  [[nodiscard]] std::int64_t noise_evaluations() const { return noise_evaluations_; }

 private:
  struct Key {
    double density;
    int seed;
    bool operator==(const Key&) const = default;
  };

  gl::Program program_{"stars/noise"};
  std::optional<Key> key_;
  std::unique_ptr<gl::Squares> squares_;
  std::int64_t noise_evaluations_ = 0;
};

}  // namespace terrella
