#include "scene/surprise.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "scene/morph.hpp"
#include "scene/presets.hpp"
#include "scene/view_groups.hpp"

namespace terrella {
namespace {

// The same on every machine, which the standard's distributions are not.
class Dice {
 public:
  explicit Dice(std::uint32_t seed) : random_(seed) {}

  double share() { return static_cast<double>(random_()) / 4294967296.0; }  // below 1
  int whole(int from, int to) { return from + static_cast<int>(share() * (static_cast<double>(to) - from + 1.0)); }

 private:
  std::mt19937 random_;
};

bool same_in(std::string_view group, const Scene& a, const Scene& b) {
  return std::all_of(parameters().begin(), parameters().end(), [&](const Parameter& parameter) {
    return parameter.group != group || parameter.get(a) == parameter.get(b);
  });
}

// One preset for each content that a group has: most leave waves and stars as they are, and would outweigh the others.
// But rings are the exception, and are to stay it; and waves, of which each sea has its own, would be the rule.
std::vector<const Scene*> kinds_of(std::string_view group) {
  const bool as_often_as_there = group == "rings" || group == "waves";
  std::vector<const Scene*> kinds;
  for (const Preset& preset : presets()) {
    const auto same = [&](const Scene* kind) { return same_in(group, *kind, preset.scene); };
    if (as_often_as_there || std::none_of(kinds.begin(), kinds.end(), same)) kinds.push_back(&preset.scene);
  }
  return kinds;
}

Scene near_a_preset(std::string_view group, Dice& dice) {
  const std::vector<const Scene*> kinds = kinds_of(group);
  const auto any = [&]() -> const Scene& {
    return *kinds[static_cast<std::size_t>(dice.whole(0, static_cast<int>(kinds.size()) - 1))];
  };
  const Scene& from = any();
  const Scene& to = any();
  return morph(from, to, 0.5 * dice.share());
}

// To four digits, which nobody tells from more: links are short.
double rounded(double value) {
  if (value == 0.0) return value;
  const double decimals = 3.0 - std::floor(std::log10(std::fabs(value)));
  const double factor = std::pow(10.0, std::fabs(decimals));  // whole, so that 2.03 comes out as 2.03
  return decimals < 0.0 ? std::round(value / factor) * factor : std::round(value * factor) / factor;
}

void take(Scene& scene, const Parameter& parameter, const Scene& from) {
  Value value = parameter.get(from);
  if (auto* number = std::get_if<double>(&value)) *number = std::clamp(rounded(*number), parameter.min, parameter.max);
  if (parameter.grows_with_planet()) {
    const double grown = std::get<double>(value) * (scene.planet.radius / from.planet.radius);
    value = std::clamp(grown, parameter.min, parameter.max);
  }
  assign(scene, parameter, value);
}

void take_group(Scene& scene, std::string_view group, const Scene& from, Dice& dice) {
  for (const Parameter& parameter : parameters()) {
    if (parameter.group != group || !is_for_chance(parameter)) continue;
    take(scene, parameter, from);
    if (parameter.is_seed()) {
      assign(scene, parameter, dice.whole(static_cast<int>(parameter.min), static_cast<int>(parameter.max)));
    }
  }
}

// Where only one of height and level may change, it follows the other: else all were flooded, or dry.
void match_level(Scene& scene, const Scene& before, const Locks& locked) {
  const bool height_stays = locked.contains("terrain.height"), level_stays = locked.contains("water.level");
  if (height_stays == level_stays) return;
  const auto factor = [](double kept, double drawn) { return drawn > 0.0 ? std::clamp(kept / drawn, 0.5, 2.0) : 1.0; };
  if (height_stays) {
    scene.water.level *= factor(before.terrain.height, scene.terrain.height);
    return;
  }
  const double by = factor(before.water.level, scene.water.level);
  auto& terrain = scene.terrain;
  for (double* length : {&terrain.height, &terrain.sand_height, &terrain.mountain_height, &terrain.snow_height}) {
    *length *= by;
  }
}

}  // namespace

bool is_for_chance(const Parameter& parameter) {
  const bool is_file = parameter.type == Type::File;  // the user's own, which no preset has
  // What a metre of water does to light says something only together with the planet's size.
  const bool is_of_size = parameter.path == "planet.radius" || parameter.path == "water.medium";
  const bool is_of_camera = parameter.path == "water.dive";
  return !is_of_view(parameter.group) && !is_of_size && !is_of_camera && !is_file;
}

Scene surprise(const Scene& scene, const Locks& locked, std::uint32_t seed) {
  Dice dice(seed);
  Scene drawn = scene;
  for (const Group& group : groups()) {
    if (is_of_view(group.name) || group.name == "water") continue;  // water comes with terrain
    const Scene found = near_a_preset(group.name, dice);
    take_group(drawn, group.name, found, dice);
    if (group.name == "terrain") take_group(drawn, "water", found, dice);
    if (group.name == "sun") {
      const double beside = found.sun.longitude - found.camera.longitude;
      drawn.sun.longitude = std::remainder(scene.camera.longitude + beside, 360.0);
    }
  }
  match_level(drawn, scene, locked);
  for (const std::string_view path : locked) {
    if (const Parameter* parameter = find_parameter(path)) assign(drawn, *parameter, parameter->get(scene));
  }
  return drawn;
}

}  // namespace terrella
