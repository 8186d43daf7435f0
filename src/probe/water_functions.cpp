// Water as the picture has them. Definitions and bounds of errors: docs/numerics.md.
#include <algorithm>

#include <glm/geometric.hpp>

#include "probe/scene_arguments.hpp"

namespace terrella::probe {
namespace {

Arg look_argument() {
  return {"look",
          Kind::object,
          "",
          any,
          false,
          {},
          {{"color", Kind::spread, "", parts},
           {"extinction", Kind::spread, "1/radius", {0.0, 1e7}},
           {"foam_color", Kind::spread, "", parts},
           {"refraction_index", Kind::number, "", {1.0, 3.0}},
           {"shininess", Kind::number, "", {1.0, 1000.0}},
           {"glow", Kind::number, "", {0.0, 20.0}},
           {"shading", Kind::word, "", any, false, {"schlick", "phong"}}}};
}

// A normal of the water that faces the eye, and a sun that is mostly near where its reflection is seen.
void fit_water(Json& args, Random& random) {
  place_eye(args["scene"], random);
  const glm::dvec3 normal = triple(args, "normal"), ray = triple(args, "ray");
  if (glm::dot(normal, ray) > 0.0) args["ray"] = list(-ray);
  if (random.chance(0.5)) return;
  const glm::dvec3 seen = glm::reflect(triple(args, "ray"), normal);
  args["scene"]["sun"] = unit(seen + random.log_between(1e-4, 1.0) * random.on_sphere());
}

Function glitter() {
  Formula f;
  f.name = "glitter";
  f.args = {{"normal_half", Kind::number, "", components},
            {"normal_view", Kind::number, "", components},
            {"normal_light", Kind::number, "", components},
            {"roughness", Kind::number, "", {0.02, 1.0}}};
  f.outputs = {{"light", 0}};
  f.fit = [](Json& args, Random& random) {
    if (random.chance(0.5)) args["normal_half"] = 1.0 - random.log_between(1e-7, 1.0);
  };
  f.on_cpu = 8.0;
  f.on_gpu = 8.0;
  return function_of(f);
}

Function refracted_ray() {
  Formula f;
  f.name = "refracted_ray";
  f.args = {{"ray", Kind::triple, "", components},
            {"normal", Kind::triple, "", components},
            {"up", Kind::triple, "", components},
            {"index", Kind::number, "", {1.0, 3.0}}};
  f.outputs = {{"ray", 0, 3}, {"dive", 3}};
  f.made_from = [](std::span<const double>) { return 1.0; };
  f.fit = [](Json& args, Random& random) {
    // From the air.
    const glm::dvec3 normal = triple(args, "normal"), ray = triple(args, "ray");
    if (glm::dot(normal, ray) > 0.0) args["ray"] = list(-ray);
    if (random.chance(0.8)) args["up"] = unit(normal + random.between(0.0, 1.0) * triple(args, "up"));
  };
  return function_of(f);
}

Function light_through() {
  Formula f;
  f.name = "light_through";
  f.args = {{"albedo", Kind::spread, "", parts},
            {"normal", Kind::triple, "", components},
            {"up", Kind::triple, "", components},
            {"depth", Kind::number, "radii", {0.0, 1.0}},
            {"way", Kind::number, "radii", {0.0, 4.0}},
            {"shade", Kind::number, "", parts},
            look_argument(),
            scene_argument()};
  f.outputs = {{"light", 0, 3}};
  f.made_from = brightest_of_scene(25);
  f.fit = [](Json& args, Random& random) {
    place_eye(args["scene"], random);
    // Mostly some light comes back.
    if (random.chance(0.2)) return;
    args["depth"] = random.log_between(1e-6, 1.0);
    args["way"] = number(args, "depth") * random.between(1.0, 4.0);
    for (Json& one : args["look"]["extinction"]) one = random.log_between(1e-3, 10.0) / number(args, "depth");
  };
  f.on_gpu = 64.0;
  f.rarity = 4;
  return function_of(f);
}

// What the surface sends to a side. through: the name of what is seen through it; third: of what only this side asks
// for.
Formula light_of_surface(const char* name, const char* through, const Arg& third) {
  Formula f;
  f.name = name;
  f.args = {{"normal", Kind::triple, "", components},
            {"up", Kind::triple, "", components},
            {"ray", Kind::triple, "", components},
            {through, Kind::spread, "", brightness},
            {"mirrored", Kind::spread, "", brightness},
            third,
            {"roughness", Kind::number, "", {0.02, 1.0}},
            {"shade", Kind::number, "", parts},
            look_argument(),
            scene_argument()};
  f.outputs = {{"light", 0, 3}};
  const auto of_scene = brightest_of_scene(31);
  f.made_from = [of_scene](std::span<const double> numbers) {
    return std::max(of_scene(numbers), *std::max_element(numbers.begin() + 9, numbers.begin() + 15));
  };
  f.rarity = 4;
  f.on_cpu = 16.0;
  f.on_gpu = 64.0;
  return f;
}

Function water_light() {
  Formula f = light_of_surface("water_light", "below", {"foam", Kind::number, "", parts});
  f.fit = fit_water;
  return function_of(f);
}

Function through_water() {
  Formula f;
  f.name = "through_water";
  f.args = {{"light", Kind::spread, "", brightness},
            {"up", Kind::triple, "", components},
            {"depth", Kind::number, "radii", {0.0, 1.0}},
            {"climb", Kind::number, "", components},
            {"way", Kind::number, "radii", {0.0, 1000.0}},
            {"shade", Kind::number, "", parts},
            look_argument(),
            scene_argument()};
  f.outputs = {{"light", 0, 3}};
  const auto of_scene = brightest_of_scene(23);
  f.made_from = [of_scene](std::span<const double> numbers) {
    return std::max(of_scene(numbers), *std::max_element(numbers.begin(), numbers.begin() + 3));
  };
  f.fit = [](Json& args, Random& random) {
    place_eye(args["scene"], random);
    // Up to the surface at the most, and mostly some light comes through.
    args["depth"] = random.log_between(1e-6, 1.0);
    args["way"] = number(args, "depth") * random.log_between(0.1, 10.0);
    args["climb"] = random.between(-1.0, std::min(1.0, number(args, "depth") / number(args, "way")));
    if (random.chance(0.2)) return;
    for (Json& one : args["look"]["extinction"]) one = random.log_between(1e-3, 10.0) / number(args, "depth");
  };
  f.on_gpu = 64.0;
  f.rarity = 4;
  return function_of(f);
}

// From the water.
void turn_upwards(Json& args) {
  const glm::dvec3 normal = triple(args, "normal"), ray = triple(args, "ray");
  if (glm::dot(normal, ray) < 0.0) args["ray"] = list(-ray);
}

Function ray_above() {
  Formula f;
  f.name = "ray_above";
  f.args = {{"ray", Kind::triple, "", components},
            {"facing", Kind::triple, "", components},
            {"index", Kind::number, "", {1.0, 3.0}}};
  f.outputs = {{"ray", 0, 3}};
  f.made_from = [](std::span<const double>) { return 1.0; };
  f.fit = [](Json& args, Random&) {
    if (glm::dot(triple(args, "facing"), triple(args, "ray")) > 0.0) args["ray"] = list(-triple(args, "ray"));
  };
  return function_of(f);
}

Function water_light_below() {
  Formula f = light_of_surface("water_light_below", "above", {"variance", Kind::number, "", {0.0, 0.1}});
  f.fit = [](Json& args, Random& random) {
    place_eye(args["scene"], random);
    turn_upwards(args);
  };
  return function_of(f);
}

Function altitude_seen() {
  Formula f;
  f.name = "altitude_seen";
  f.args = {{"r", Kind::number, "", {0.5, 2.0}},
            {"alt", Kind::number, "", {1e-9, 1.0}},
            {"cosine", Kind::number, "", components},
            {"distance", Kind::number, "", {1e-9, 1.0}}};
  f.outputs = {{"altitude", 0}};
  f.made_from = [](std::span<const double> numbers) { return numbers[1] + numbers[3]; };
  return function_of(f);
}

Function way_in_mirror() {
  Formula f;
  f.name = "way_in_mirror";
  f.args = {{"r", Kind::number, "", {0.5, 2.0}},
            {"alt", Kind::number, "", {1e-9, 1.0}},
            {"cosine", Kind::number, "", components},
            {"rise", Kind::number, "", components}};
  f.outputs = {{"way", 0}};
  return function_of(f);
}

}  // namespace

std::vector<Function> water_functions() {
  return {glitter(),   refracted_ray(),     light_through(), water_light(),  through_water(),
          ray_above(), water_light_below(), altitude_seen(), way_in_mirror()};
}

}  // namespace terrella::probe
