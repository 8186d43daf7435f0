// How evenly and how long time runs.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "measure/limits.hpp"
#include "measure/stability.hpp"
#include "measure/trials.hpp"
#include "planet/waves.hpp"
#include "scene/choices.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

// By how much (rad) a wave's step in a 64th of a second differs from its first one.
double step_error(const Scene& scene, double seconds) {
  constexpr double step = 1.0 / 64.0;  // exact, also after 30 years
  const auto phases = [&](double time) { return make_sea(scene, time).waves; };
  const auto first = phases(0.0), second = phases(step), third = phases(seconds), fourth = phases(seconds + step);
  double largest = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    const double at_first = double{second[i].phase} - double{first[i].phase};
    const double later = double{fourth[i].phase} - double{third[i].phase};
    largest = std::max(largest, std::abs(std::remainder(later - at_first, 2.0 * std::numbers::pi)));
  }
  return largest;
}

Limit wave_speeds() {
  Scene start = find_preset("storm")->scene;
  start.water.model = choice("water.model", "waves");
  return follow(
      {"waves", "waves.speed", "m/s, after 1e9 s", "step of a phase that differs from the first one, rad", 0.01, {}},
      start, {0.05, 1.0, 10.0, 1e3, 1e4, 1e6},
      [](Scene& scene, View& view, double value) {
        scene.waves.speed = value;
        view.seconds = 1e9;
      },
      [](const Scene& scene, const View& view) { return step_error(scene, view.seconds); });
}

Limit times(Renderer& renderer, const char* technique, const char* preset, Channel channel, double demand) {
  return follow(
      {technique, "time", "s", "change of the change from frame to frame, as a part of it", demand, {}}, cheap(preset),
      {0.0, 1.0, 1e3, 1e6, 1e9}, [](Scene&, View& view, double value) { view.seconds = value; },
      [&renderer, channel](const Scene& scene, const View& view) {
        return motion_at(renderer, scene, view, view.seconds, channel).unrest;
      });
}

}  // namespace

std::vector<Limit> limits_of_time(Renderer& renderer, Extent extent) {
  std::vector<Limit> limits = {wave_speeds()};
  if (extent == Extent::sample) return limits;
  // Measured: clouds 0.003, waves 0.07.
  limits.push_back(times(renderer, "clouds", "temperate", Channel::color, 0.02));
  limits.push_back(times(renderer, "waves", "storm", Channel::normal, 0.15));
  return limits;
}

}  // namespace terrella
