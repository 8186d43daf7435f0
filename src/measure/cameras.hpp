// From where a scene is looked at to judge its settings.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace terrella {

struct Viewpoint {
  std::string name;  // "own"; tells it from the others
  std::string what;  // a few words: "the scene's own view"
  Scene::camera_group place;
};

// The scene's own view; one from close by that sees ground and horizon; one over the border of day and night that sees
// the limb. They depend on nothing but the scene.
std::vector<Viewpoint> cameras_of(const Scene& scene);

// The scene with its camera in another place.
Scene seen_by(Scene scene, const Viewpoint& camera);

}  // namespace terrella
