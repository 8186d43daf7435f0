// Sunlight, sky and air as the picture has them. Definitions and bounds of errors: docs/numerics.md.
#include <algorithm>

#include <glm/geometric.hpp>

#include "probe/scene_arguments.hpp"

namespace terrella::probe {
namespace {

void fit_scene(Json& args, Random& random) { place_eye(args["scene"], random); }

Function light_at() {
  Formula f;
  f.name = "light_at";
  f.args = {{"up", Kind::triple, "", components}, {"height", Kind::number, "radii", {0.0, 1.0}}, scene_argument()};
  f.outputs = {{"sun", 0, 3}, {"air", 3, 3}};
  f.made_from = brightest_of_scene(4);
  f.fit = fit_scene;
  f.rarity = 3;
  return function_of(f);
}

Function air_opacity() {
  Formula f;
  f.name = "air_opacity";
  f.args = {{"cosine", Kind::number, "", parts}, air_shell()};
  f.outputs = {{"opacity", 0}};
  f.made_from = [](std::span<const double>) { return 1.0; };
  f.on_gpu = 64.0;
  return function_of(f);
}

Function air_opacity_before() {
  Formula f;
  f.name = "air_opacity_before";
  f.args = {{"opacity", Kind::number, "", parts},
            {"cosine", Kind::number, "", parts},
            {"path", Kind::number, "radii", {0.0, 4.0}},
            {"top", Kind::number, "radii", tops}};
  f.outputs = {{"opacity", 0}};
  f.made_from = [](std::span<const double>) { return 1.0; };
  f.fit = [](Json& args, Random& random) {
    if (random.chance(0.5)) args["path"] = random.log_between(1e-6, 4.0);
  };
  f.on_gpu = 64.0;
  return function_of(f);
}

Function sky_along() {
  Formula f;
  f.name = "sky_along";
  f.args = {{"up", Kind::triple, "", components},
            {"height", Kind::number, "radii", {0.0, 1.0}},
            {"ray", Kind::triple, "", components},
            scene_argument()};
  f.outputs = {{"light", 0, 3}};
  f.made_from = brightest_of_scene(7);
  f.fit = fit_scene;
  f.rarity = 3;
  return function_of(f);
}

Function through_air() {
  Formula f;
  f.name = "through_air";
  f.args = {{"light", Kind::spread, "", brightness},
            {"up", Kind::triple, "", components},
            {"height", Kind::number, "radii", {0.0, 1.0}},
            {"offset", Kind::triple, "radii", {-1e3, 1e3}},
            scene_argument()};
  f.outputs = {{"light", 0, 3}};
  const auto of_scene = brightest_of_scene(10);
  f.made_from = [of_scene](std::span<const double> numbers) {
    return std::max({of_scene(numbers), numbers[0], numbers[1], numbers[2]});
  };
  f.fit = [](Json& args, Random& random) {
    fit_scene(args, random);
    // What is seen lies over the place whose light it has.
    const glm::dvec3 place = triple(args, "up") * (1.0 + number(args, "height"));
    const glm::dvec3 offset = place - triple(args["scene"], "eye");
    args["offset"] = list(glm::clamp(offset, -1e3, 1e3));
  };
  f.rarity = 3;
  f.on_cpu = 64.0;
  f.on_gpu = 64.0;
  return function_of(f);
}

// A ray from the eye that often grazes the planet, whose air is thickest there.
void fit_ray(Json& args, Random& random) {
  fit_scene(args, random);
  if (random.chance(0.3)) return;
  const glm::dvec3 eye = triple(args["scene"], "eye");
  const glm::dvec3 side = glm::normalize(glm::cross(eye, random.on_sphere()));
  args["ray"] = unit(side * random.between(0.9, 2.0) - eye);
}

Function air_before_sky() {
  Formula f;
  f.name = "air_before_sky";
  f.args = {{"ray", Kind::triple, "", components}, scene_argument()};
  f.outputs = {{"light", 0, 3}, {"opacity", 3}};
  const auto of_scene = brightest_of_scene(3);
  f.made_from = [of_scene](std::span<const double> numbers) { return std::max(of_scene(numbers), 1.0); };
  f.fit = fit_ray;
  f.rarity = 3;
  f.on_cpu = 64.0;
  f.on_gpu = 64.0;
  return function_of(f);
}

Function sky_shown() {
  Formula f;
  f.name = "sky_shown";
  f.args = {{"ray", Kind::triple, "", components}, scene_argument()};
  f.outputs = {{"part", 0}};
  f.made_from = [](std::span<const double>) { return 1.0; };
  f.fit = fit_ray;
  f.rarity = 3;
  f.on_gpu = 64.0;
  return function_of(f);
}

Function sunlight_at_eye() {
  Formula f;
  f.name = "sunlight_at_eye";
  f.args = {scene_argument()};
  f.outputs = {{"light", 0, 3}};
  f.made_from = brightest_of_scene(0);
  f.fit = fit_scene;
  f.rarity = 3;
  return function_of(f);
}

}  // namespace

std::vector<Function> light_functions() {
  return {light_at(),    air_opacity(),    air_opacity_before(), sky_along(),
          through_air(), air_before_sky(), sky_shown(),          sunlight_at_eye()};
}

}  // namespace terrella::probe
