#include "probe/scene_arguments.hpp"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace terrella::probe {

Arg air_shell() {
  return {"air",
          Kind::object,
          "",
          any,
          false,
          {},
          {{"top", Kind::number, "radii", tops},
           {"density", Kind::number, "", parts},
           {"exponent", Kind::number, "", {0.0, 32.0}},
           {"wrap", Kind::number, "", parts},
           {"color", Kind::spread, "", parts},
           {"dusk", Kind::spread, "", parts}}};
}

Arg scene_argument() {
  return {"scene",
          Kind::object,
          "",
          any,
          false,
          {},
          {{"eye", Kind::triple, "radii", {-farthest_eye, farthest_eye}},
           {"eye_height", Kind::number, "radii", {0.0, farthest_eye}},
           {"sun", Kind::triple, "", components},
           {"sunlight", Kind::spread, "", brightness},
           {"ambient", Kind::number, "", {0.0, 2.0}},
           {"sky_glow", Kind::spread, "", brightness},
           air_shell()}};
}

void place_eye(Json& scene, Random& random) {
  const double height = random.log_between(nearest_eye, random.chance(0.7) ? 1.0 : 0.99 * farthest_eye);
  const glm::dvec3 eye = triple(rounded(random.on_sphere() * (1.0 + height)));
  scene["eye"] = list(eye);
  scene["eye_height"] = std::max(glm::length(eye) - 1.0, 0.0);
}

std::function<double(std::span<const double>)> brightest_of_scene(std::size_t scene) {
  return [scene](std::span<const double> numbers) {
    double most = 0.0;
    for (const std::size_t sunlight_or_glow : {7U, 8U, 9U, 11U, 12U, 13U}) {
      most = std::max(most, numbers[scene + sunlight_or_glow]);
    }
    return most;
  };
}

Json unit(const glm::dvec3& v) { return list(glm::clamp(v / glm::length(v), -1.0, 1.0)); }

}  // namespace terrella::probe
