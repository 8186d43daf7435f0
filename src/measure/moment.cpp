#include "measure/moment.hpp"

#include "planet/needs.hpp"

namespace terrella {

double judged_at(const Scene& scene) {
  constexpr double day = 86'400.0;  // s
  const double speed = scene.clouds.speed;
  return speed > 0.0 && longest_blend_turn / speed < day ? longest_blend_turn / speed / 3.0 : 0.0;
}

}  // namespace terrella
