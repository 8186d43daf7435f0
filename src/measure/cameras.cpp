#include "measure/cameras.hpp"

#include <cmath>

namespace terrella {
namespace {

// Nearer than this, most of what is seen is computed in pixels; farther, by maps and mesh. Both are in the picture.
Scene::camera_group close_by(const Scene& scene) {
  Scene::camera_group place = scene.camera;
  place.altitude = 0.25 * scene.planet.radius;
  place.heading = 0.0;
  place.pitch = -35.0;
  place.fov = 45.0;
  return place;
}

// The border of day and night runs up the middle of the picture; the limb lies across its upper half.
Scene::camera_group over_the_border(const Scene& scene) {
  Scene::camera_group place;
  place.latitude = 0.0;
  place.longitude = std::remainder(scene.sun.longitude + 88.0, 360.0);
  place.altitude = 1.2 * scene.planet.radius;
  place.heading = 0.0;
  place.pitch = -74.0;
  place.fov = 45.0;
  return place;
}

}  // namespace

std::vector<Viewpoint> cameras_of(const Scene& scene) {
  return {{"own", "the scene's own view", scene.camera},
          {"close", "close by: ground and horizon", close_by(scene)},
          {"border", "over the border of day and night: the limb", over_the_border(scene)}};
}

Scene seen_by(Scene scene, const Viewpoint& camera) {
  scene.camera = camera.place;
  return scene;
}

}  // namespace terrella
