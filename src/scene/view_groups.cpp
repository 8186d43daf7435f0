#include "scene/view_groups.hpp"

#include <algorithm>

#include "scene/parameters.hpp"

namespace terrella {

bool is_of_view(std::string_view group) {
  return group == "camera" || group == "picture" || group == "time" || group == "quality";
}

Scene seen_as(Scene scene, const Scene& seen) {
  static const double highest = find_parameter("camera.altitude")->max;
  scene.camera = seen.camera;
  scene.camera.altitude = std::min(highest, seen.camera.altitude * (scene.planet.radius / seen.planet.radius));
  scene.picture = seen.picture;
  scene.time = seen.time;
  scene.quality = seen.quality;
  return scene;
}

}  // namespace terrella
