#include "measure/invariances.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include "base/numbers.hpp"
#include "base/text.hpp"
#include "measure/stability.hpp"
#include "measure/trials.hpp"
#include "scene/choices.hpp"
#include "scene/parameters.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

Invariance scaled_by(Renderer& renderer, const char* preset, double factor, double bound) {
  Scene scene = cheap(preset);
  // A wind's waves, and the way of light in waters of nature, are as long on any planet.
  scene.waves.spectrum = choice("waves.spectrum", "free");
  const int tinted = choice("water.medium", "tinted");
  if (scene.water.medium != tinted) scene.water.clarity *= scene.planet.radius;
  scene.water.medium = tinted;
  const std::vector<float> as_it_is = light_of(renderer, scene, small_view());
  const std::vector<float> scaled_up = light_of(renderer, scaled(scene, factor), small_view());
  return {text_of(preset, ", all lengths times ", factor), "largest difference of light",
          largest_difference(as_it_is, scaled_up), bound, contrast_of(as_it_is)};
}

// A sphere of calm water under air, in which nothing has a place of its own.
Scene plain_sphere() {
  Scene scene = bare_sea();
  scene.water.ripples = scene.stars.density = scene.stars.band = 0.0;
  scene.quality.pixel_error = 0.1;
  scene.camera.latitude = 0.0;
  scene.sun.latitude = -20.0;
  scene.sun.longitude = -40.0;
  return scene;
}

Invariance turned_by(Renderer& renderer, double longitude, double latitude, double bound) {
  Scene scene = plain_sphere();
  // Along one meridian, latitude turns both as well.
  if (latitude != 0.0) scene.sun.longitude = scene.camera.longitude;
  Scene turned = scene;
  turned.camera.longitude += longitude;
  turned.sun.longitude += longitude;
  turned.camera.latitude += latitude;
  turned.sun.latitude += latitude;
  const std::vector<float> as_it_is = light_of(renderer, scene, small_view());
  const std::vector<float> after = light_of(renderer, turned, small_view());
  return {text_of("sea under air, turned by ", longitude, " deg of longitude and ", latitude, " of latitude"),
          "root of the mean square difference of light", mean_difference(as_it_is, after), bound,
          contrast_of(as_it_is)};
}

// How far hills move where the camera comes so near that the mesh of the ground is made with finer triangles. These may
// miss finer ones by 2.5 times quality.pixel_error (simplified, planet/icosphere_groups.hpp). Seen from the side:
// straight below, hills rise towards the eye and not across the picture.
Invariance pops_by(Renderer& renderer, const char* preset) {
  const View view = small_view();
  Scene near = bare_ground(preset), far = near;
  near.camera.pitch = far.camera.pitch = -50.0;
  near.camera.altitude = 0.6;
  far.camera.altitude = 0.8;
  const auto tolerance = [&](const Scene& scene) {
    return needs_of(scene, view, pose_of(scene, view)).ground_tolerance;
  };
  const double far_tolerance = tolerance(far);
  while (far.camera.altitude - near.camera.altitude > 1e-9) {
    Scene middle = near;
    middle.camera.altitude = 0.5 * (near.camera.altitude + far.camera.altitude);
    (tolerance(middle) == far_tolerance ? far : near) = middle;
  }
  const auto distances = [&](const Scene& scene) {
    renderer.draw(scene, view, {Channel::distance, Effort::complete, true});
    return renderer.read_light();
  };
  const std::vector<float> before = distances(far), after = distances(near);
  const Jitter jump = jitter_between(before, after, view.width, view.height, 1, 1e-8);
  return {text_of(preset, ", as the camera comes nearer and the mesh finer"),
          "that 99 of 100 pixels of hills jump less than, px", jump.nearly_all, 2.5 * near.quality.pixel_error,
          jump.nearly_all};
}

// After a million whole periods of all that moves in it.
Invariance repeats_after(Renderer& renderer, const char* what, const Scene& scene, double period, double bound) {
  constexpr double periods = 1e6;
  const std::vector<float> first = light_of(renderer, scene, small_view());
  const std::vector<float> later = light_of(renderer, scene, small_view(periods * period));
  const std::vector<float> between = light_of(renderer, scene, small_view(0.4 * period));
  const double apart = mean_difference(first, later), moved = mean_difference(first, between);
  return {text_of(what, ", after a million periods"), "difference of light, as a part of that after 0.4 periods",
          apart / moved, bound, moved};
}

std::vector<Invariance> repetitions(Renderer& renderer, double bound) {
  Scene still = cheap("temperate");
  still.clouds.speed = still.clouds.drift = still.water.ripple_speed = 0.0;
  Scene drifting = still, rippled = still, waving = still;
  drifting.clouds.drift = 0.5;
  rippled.water.ripple_speed = 1.2;
  rippled.camera.altitude = 0.3;
  waving.waves.count = 1;
  waving.camera.altitude = 0.5;
  return {repeats_after(renderer, "drifting clouds", drifting, 360.0 / drifting.clouds.drift, bound),
          repeats_after(renderer, "ripples", rippled, 2.0 * std::numbers::pi / rippled.water.ripple_speed, bound),
          repeats_after(renderer, "a wave", waving, waving.waves.length / waving.waves.speed, bound)};
}

}  // namespace

Invariance moves_alike(Renderer& renderer, const std::string& name, const Scene& scene, Channel channel, double bound) {
  constexpr int pictures = 8;  // far apart: one may show few clouds, the next one many
  const auto mean_change = [&](double from) {
    double sum = 0.0;
    for (int i = 0; i < pictures; ++i) sum += motion_at(renderer, scene, small_view(), from + 97.3 * i, channel).change;
    return sum / pictures;
  };
  const double first = mean_change(0.0), late = mean_change(1e9);
  const auto [less, more] = std::minmax(first, late);
  return {text_of(name, ", after 1e9 s against the beginning"),
          "change from frame to frame, the larger as a multiple of the smaller", more / less, bound, less};
}

std::vector<Invariance> measure_invariances(Renderer& renderer, Extent extent) {
  std::vector<Invariance> found = {scaled_by(renderer, "temperate", 1048576.0, 0.0)};
  if (extent == Extent::sample) return found;
  for (const Preset& preset : presets()) {
    for (const double factor : {16.0, 67108864.0}) {
      found.push_back(scaled_by(renderer, preset.name.c_str(), factor, 0.0));
    }
  }
  // Factors that are no power of two may round the last bit of a length; measured: 0.
  found.push_back(scaled_by(renderer, "temperate", 6.371e6, 1e-3));
  found.push_back(scaled_by(renderer, "storm", 6.371e6, 1e-3));
  // The sea's triangles lie elsewhere; measured: 2.6e-4.
  found.push_back(turned_by(renderer, 72.0, 0.0, 1e-3));
  found.push_back(turned_by(renderer, 123.4, 0.0, 1e-3));
  found.push_back(turned_by(renderer, 0.0, 50.0, 1e-3));
  // Measured: 1.43, 0.97 and 0.75. Of a planet as smooth as mars too few triangles change to tell.
  for (const char* preset : {"moon", "alps", "desert"}) found.push_back(pops_by(renderer, preset));
  // Measured: 0, to the last bit.
  for (Invariance& repetition : repetitions(renderer, 1e-3)) found.push_back(std::move(repetition));
  // Measured: 1.01 and 1.001.
  found.push_back(moves_alike(renderer, "temperate", cheap("temperate"), Channel::color, 1.3));
  found.push_back(moves_alike(renderer, "storm", cheap("storm"), Channel::normal, 1.3));
  return found;
}

}  // namespace terrella
