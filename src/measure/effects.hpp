// What of a scene can be left out, to see what it costs and what it adds: a line each.
#pragma once

#include <span>

#include "scene/scene.hpp"

namespace terrella {

struct Effect {
  const char* name;   // "clouds"; tells it from the others
  const char* title;  // "Clouds"
  void (*leave_out)(Scene& scene);
};

std::span<const Effect> effects();

// Whether leaving it out would change anything of what the scene shows.
bool has(const Scene& scene, const Effect& effect);

}  // namespace terrella
