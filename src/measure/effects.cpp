#include "measure/effects.hpp"

#include <string_view>

#include "planet/lights.hpp"
#include "planet/materials.hpp"
#include "planet/rings.hpp"
#include "planet/terrain.hpp"
#include "scene/choices.hpp"

namespace terrella {
namespace {

constexpr Effect all_effects[] = {
    {"clouds", "Clouds", [](Scene& s) { s.clouds.model = choice("clouds.model", "none"); }},
    {"cloud_shadow", "The clouds' shadow", [](Scene& s) { s.clouds.shadow = 0.0; }},
    {"water", "Water", [](Scene& s) { s.water.model = choice("water.model", "none"); }},
    {"waves", "Waves (else a calm sea)", [](Scene& s) { s.waves.count = 0; }},
    {"ripples", "Ripples", [](Scene& s) { s.water.ripples = 0.0; }},
    {"foam", "Foam", [](Scene& s) { s.water.foam = 0.0; }},
    {"air", "Air", [](Scene& s) { s.air.model = choice("air.model", "none"); }},
    {"hollows", "Darkness of hollows", [](Scene& s) { s.terrain.hollows = 0.0; }},
    {"craters", "Craters", [](Scene& s) { s.terrain.craters = 0.0; }},
    {"stars", "Stars", [](Scene& s) { s.stars.model = choice("stars.model", "none"); }},
    {"band", "Milky band", [](Scene& s) { s.stars.band = 0.0; }},
    {"lights", "Lights by night", [](Scene& s) { s.lights.density = 0.0; }},
    {"rings", "Rings", [](Scene& s) { s.rings.density = 0.0; }},
    {"sun", "The sun's disc and glare", [](Scene& s) { s.sun.size = s.sun.glare = 0.0; }},
    {"antialias", "Smooth edges", [](Scene& s) { s.quality.antialias = false; }},
};

// What cannot be seen is as good as not there: its parameters then say nothing.
Scene without_the_unseen(Scene scene) {
  const Scene nothing;
  if (!has_clouds(scene)) {
    scene.clouds = nothing.clouds;
    scene.clouds.model = choice("clouds.model", "none");
    scene.clouds.shadow = 0.0;
  }
  if (!has_water(scene)) {
    scene.water.model = choice("water.model", "none");
    scene.waves.count = 0;
    scene.water.ripples = scene.water.foam = 0.0;
  }
  if (scene.waves.count > 0) scene.water.ripples = 0.0;  // a sea of waves has no others
  if (!has_air(scene)) scene.air.model = choice("air.model", "none");
  if (!has_ground(scene)) scene.terrain.hollows = scene.terrain.craters = 0.0;
  if (!has_stars(scene)) {
    scene.stars.model = choice("stars.model", "none");
    scene.stars.band = 0.0;
  }
  if (!has_lights(scene)) scene.lights.density = 0.0;
  if (!has_rings(scene)) scene.rings.density = 0.0;
  if (scene.sun.intensity == 0.0) scene.sun.size = scene.sun.glare = 0.0;
  return scene;
}

}  // namespace

std::span<const Effect> effects() { return all_effects; }

bool has(const Scene& scene, const Effect& effect) {
  const Scene seen = without_the_unseen(scene);
  Scene without = seen;
  effect.leave_out(without);
  return without != seen;
}

}  // namespace terrella
