#include "measure/moment.hpp"

#include "planet/needs.hpp"

namespace terrella {

double judged_at(const Scene& scene) {
  constexpr double day = 86'400.0;  // s
  const double speed = scene.clouds.speed;
  if (speed <= 0.0) return 0.0;
  const double longest = longest_blend_turn / speed;
  return longest < day ? longest / 3.0 : 0.0;
}

}  // namespace terrella
