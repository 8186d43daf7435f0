#include "measure/knobs.hpp"

#include <algorithm>
#include <optional>

#include "base/check.hpp"
#include "planet/materials.hpp"
#include "planet/terrain.hpp"

namespace terrella {
namespace {

std::optional<double> number_in(const Value& value) {
  if (const auto* number = std::get_if<double>(&value)) return *number;
  if (const auto* number = std::get_if<int>(&value)) return *number;
  return std::nullopt;
}

// Whether a knob's values are numbers that fall on the way to the most accurate one.
bool falls(const Knob& knob) {
  const auto first = number_in(knob.values.front()), last = number_in(knob.values.back());
  return first && last && *first > *last;
}

// The values with one more, in its place if it is a number.
std::vector<Value> with(const Knob& knob, const Value& own) {
  std::vector<Value> values = knob.values;
  if (std::find(values.begin(), values.end(), own) != values.end()) return values;
  const std::optional<double> number = number_in(own);
  const auto lies_beyond = [&](const Value& value) {
    const std::optional<double> other = number_in(value);
    return number && other && (falls(knob) ? *other < *number : *other > *number);
  };
  values.insert(std::find_if(values.begin(), values.end(), lies_beyond), own);
  return values;
}

bool clouds_change(const Scene& scene) { return has_clouds(scene) && scene.clouds.speed > 0.0; }
bool has_waves(const Scene& scene) { return has_water(scene) && scene.waves.count > 0; }

}  // namespace

// They begin where less accuracy still saves time: a mesh further off takes as long as one of 2 px (llvmpipe), and
// clouds that lose more of their noise are gone.
std::span<const Knob> knobs() {
  static const std::vector<Knob> all = {
      {"quality.resolution_scale", {0.5, 0.7, 1.0, 1.4, 2.0, 3.0, 4.0}},
      {"quality.pixel_error", {2.0, 0.75, 0.3, 0.15}},
      {"quality.antialias", {false, true}},
      {"quality.finest_layer", {8.0, 4.0, 2.0, 1.0}},
      {"quality.ground_texels", {256, 512, 1024}},
      {"quality.ground_texel_size", {64.0, 4.0, 1.7, 0.5}},
      {"quality.cloud_texels", {128, 256, 384, 768}},
      {"quality.cloud_texel_size", {64.0, 8.0, 4.0, 1.0}},
      {"quality.cloud_loss", {0.2, 0.08, 0.03, 0.008}, clouds_change},
      {"quality.wave_height", {4.0, 0.5, 0.1}, has_waves},
  };
  return all;
}

const Parameter& parameter_of(const Knob& knob) {
  const Parameter* parameter = find_parameter(knob.path);
  CHECK(parameter != nullptr, "no parameter ", knob.path);
  return *parameter;
}

std::vector<Value> values_for(const Knob& knob, const Scene& scene, bool few) {
  const Value own = parameter_of(knob).get(scene);
  std::vector<Value> values = with(knob, own);
  if (!few) return values;
  const auto here = std::find(values.begin(), values.end(), own);
  const auto next = here + 1 == values.end() ? here : here + 1;
  std::vector<Value> kept(here, next + 1);
  if (here != values.begin()) kept.insert(kept.begin(), values.front());
  return kept;
}

Scene turned(Scene scene, const Knob& knob, const Value& value) {
  const auto issue = assign(scene, parameter_of(knob), value);
  CHECK(!issue, issue->text());
  return scene;
}

std::string setting_id(const Scene& scene) {
  std::vector<std::string> differing;
  for (const Knob& knob : knobs()) {
    const Parameter& parameter = parameter_of(knob);
    const Value value = parameter.get(scene);
    if (value != parameter.default_value) differing.push_back(text_of(knob.path, '=', to_text(value)));
  }
  std::sort(differing.begin(), differing.end());
  std::string id;
  for (const std::string& one : differing) id += (id.empty() ? "" : "&") + one;
  return id.empty() ? "default" : id;
}

}  // namespace terrella
