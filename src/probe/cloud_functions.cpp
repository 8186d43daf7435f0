// Clouds as the picture has them. Definitions and bounds of errors: docs/numerics.md.
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "probe/scene_arguments.hpp"

namespace terrella::probe {
namespace {

constexpr Range noises{-1.5, 1.5}, shell_heights{0.0, 1.0};

Arg clouds_argument() {
  return {"clouds",
          Kind::object,
          "",
          any,
          false,
          {},
          {{"height", Kind::number, "radii", shell_heights},
           {"thickness", Kind::number, "radii", {0.0, 0.5}},
           {"coverage", Kind::number, "", parts},
           {"softness", Kind::number, "", parts},
           {"density", Kind::number, "", parts},
           {"shadow", Kind::number, "", parts},
           {"color", Kind::spread, "", parts}}};
}

Function cloud_thickness() {
  Formula f;
  f.name = "cloud_thickness";
  f.args = {{"noise", Kind::number, "", noises},
            {"coverage", Kind::number, "", parts},
            {"softness", Kind::number, "", parts}};
  f.outputs = {{"thickness", 0}};
  f.made_from = [](std::span<const double>) { return 1.0; };
  return function_of(f);
}

// A place below the shell of clouds, mostly a little.
void fit_below(Json& args, Random& random, double height) {
  const double below = random.chance(0.1) ? 0.0 : random.log_between(1e-6, 1.0);
  args["place"] = list(random.on_sphere() * (1.0 + height * (1.0 - below)));
}

Function cloud_before_sun() {
  Formula f;
  f.name = "cloud_before_sun";
  f.args = {{"place", Kind::triple, "radii", {-2.0, 2.0}}, {"sun", Kind::triple, "", components}, clouds_argument()};
  f.outputs = {{"direction", 0, 3}};
  f.made_from = [](std::span<const double>) { return 1.0; };
  f.fit = [](Json& args, Random& random) { fit_below(args, random, number(args["clouds"], "height")); };
  return function_of(f);
}

Function cloud_shade() {
  Formula f;
  f.name = "cloud_shade";
  f.args = {{"place", Kind::triple, "radii", {-2.0, 2.0}}, {"thickness", Kind::number, "", parts}, clouds_argument()};
  f.outputs = {{"part", 0}};
  f.made_from = [](std::span<const double>) { return 1.0; };
  f.fit = [](Json& args, Random& random) { fit_below(args, random, number(args["clouds"], "height")); };
  Function made = function_of(f);
  made.allowed = [of_arguments = made.allowed](const Case& c) {
    // At the shell itself there is a cloud above or there is none.
    const double away = glm::length(glm::dvec3(c.numbers[0], c.numbers[1], c.numbers[2]));
    const bool at_shell = std::fabs(away - (1.0 + c.numbers[4])) < 4.0 * u * away;
    return at_shell ? Numbers{anything} : of_arguments(c);
  };
  return made;
}

Function cloud_veil() {
  Formula f;
  f.name = "cloud_veil";
  f.args = {{"up", Kind::triple, "", components},
            {"noise", Kind::number, "", noises},
            {"rise", Kind::number, "", {-2.0, 2.0}},
            {"offset", Kind::triple, "radii", {-1e3, 1e3}},
            clouds_argument(),
            scene_argument()};
  f.outputs = {{"light", 0, 3}, {"opacity", 3}};
  f.made_from = brightest_of_scene(17);
  f.fit = [](Json& args, Random& random) {
    place_eye(args["scene"], random);
    const glm::dvec3 place = triple(args, "up") * (1.0 + number(args["clouds"], "height"));
    args["offset"] = list(glm::clamp(place - triple(args["scene"], "eye"), -1e3, 1e3));
  };
  f.rarity = 4;
  f.on_cpu = 64.0;
  f.on_gpu = 64.0;
  return function_of(f);
}

}  // namespace

std::vector<Function> cloud_functions() { return {cloud_thickness(), cloud_before_sun(), cloud_shade(), cloud_veil()}; }

}  // namespace terrella::probe
