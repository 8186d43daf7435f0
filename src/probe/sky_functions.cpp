// Rings, stars and the sun, and how light becomes a picture. Definitions and bounds of errors: docs/numerics.md.
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "probe/scene_arguments.hpp"

namespace terrella::probe {
namespace {

double one(std::span<const double> /*numbers*/) { return 1.0; }

Function ring_opacity() {
  Formula f;
  f.name = "ring_opacity";
  f.args = {{"matter", Kind::number, "", parts},
            {"density", Kind::number, "", parts},
            {"cosine", Kind::number, "", components}};
  f.outputs = {{"opacity", 0}};
  // What rounding has lost of the light that passes straight through is raised to this power.
  f.made_from = [](std::span<const double> numbers) { return 1.0 / std::fmax(std::fabs(numbers[2]), 0.08); };
  f.on_gpu = 64.0;
  return function_of(f);
}

Function ring_veil() {
  Formula f;
  f.name = "ring_veil";
  f.args = {{"place", Kind::triple, "radii", {-20.0, 20.0}},
            {"ray", Kind::triple, "", components},
            {"footprint", Kind::number, "", {1e-4, 1.0}},
            {"rings",
             Kind::object,
             "",
             any,
             false,
             {},
             {{"inner", Kind::number, "radii", {1.0, 10.0}},
              {"width", Kind::number, "radii", {0.01, 10.0}},
              {"density", Kind::number, "", parts},
              {"color", Kind::spread, "", parts},
              of_host({"seed", Kind::whole, "", seeds})}},
            scene_argument()};
  f.outputs = {{"light", 0, 3}, {"opacity", 3}};
  f.made_from = [of_scene = brightest_of_scene(15)](std::span<const double> numbers) {
    return std::fmax(of_scene(numbers), 1.0) / std::fmax(std::fabs(numbers[5]), 0.08);
  };
  f.fit = [](Json& args, Random& random) {
    place_eye(args["scene"], random);
    const double angle = random.between(0.0, turn);
    const double across = random.between(-0.1, 1.1), inner = number(args["rings"], "inner");
    const double away = inner + across * number(args["rings"], "width");
    args["place"] = list(glm::clamp(away * glm::dvec3(std::cos(angle), std::sin(angle), 0.0), -20.0, 20.0));
  };
  f.rarity = 4;
  f.on_cpu = 8.0;
  f.on_gpu = 64.0;
  return function_of(f);
}

Function star_light() {
  Formula f;
  f.name = "star_light";
  f.args = {{"warmth", Kind::number, "", components},
            {"brightness", Kind::number, "", parts},
            {"all", Kind::number, "", {0.0, 20.0}}};
  f.outputs = {{"light", 0, 3}};
  return function_of(f);
}

Function band_brightness() {
  Formula f;
  f.name = "band_brightness";
  f.args = {{"direction", Kind::triple, "", components},
            {"normal", Kind::triple, "", components},
            of_host({"seed", Kind::whole, "", seeds})};
  f.outputs = {{"part", 0}};
  f.made_from = one;
  f.fit = [](Json& args, Random& random) {
    // Along the band, for beyond it there is nothing.
    const glm::dvec3 normal = triple(args, "normal"), place = triple(args, "direction");
    args["direction"] = unit(place + (random.between(-0.3, 0.3) - glm::dot(place, normal)) * normal);
  };
  f.on_cpu = 16.0;
  f.on_gpu = 16.0;
  return function_of(f);
}

Function town_light() {
  Formula f;
  f.name = "town_light";
  f.args = {{"place", Kind::triple, "radii", {-2.0, 2.0}},
            {"offset", Kind::triple, "radii", {-1e3, 1e3}},
            {"brightness", Kind::number, "", parts},
            {"color", Kind::spread, "", parts},
            {"all", Kind::number, "", {0.0, 20.0}},
            {"pixel", Kind::number, "rad", {1e-6, 0.1}},
            scene_argument()};
  f.outputs = {{"light", 0, 3}, {"radius", 3}};
  f.fit = [](Json& args, Random& random) {
    place_eye(args["scene"], random);
    const glm::dvec3 place = random.on_sphere() * random.between(0.9, 1.5);
    args["place"] = list(place);
    args["offset"] = list(glm::clamp(place - triple(args["scene"], "eye"), -1e3, 1e3));
  };
  f.rarity = 3;
  Function made = function_of(f);
  made.allowed = [of_arguments = made.allowed](const Case& c) {
    Numbers allowed = of_arguments(c);
    // How many lights are on is what the daylight leaves of 1.
    for (std::size_t i = 0; i < 3; ++i) allowed[i] += 4.0 * u * 4.0 * c.numbers[10] * c.numbers[6];
    return allowed;
  };
  return made;
}

Function tangent_from_sun() {
  Formula f;
  f.name = "tangent_from_sun";
  f.args = {{"ray", Kind::triple, "", {-4.0, 4.0}}, {"sun", Kind::triple, "", components}};
  f.outputs = {{"tangent", 0}};
  f.fit = [](Json& args, Random& random) {
    if (random.chance(0.3)) return;
    const glm::dvec3 ray = triple(args, "sun") + random.log_between(1e-6, 1.0) * random.on_sphere();
    args["ray"] = list(random.log_between(0.1, 1.9) * ray);
  };
  return function_of(f);
}

// Tangents of angles.
constexpr Range discs{1e-4, 1.0}, pixels{1e-5, 0.1}, aways{0.0, 1e6};

Function disc_of_sun() {
  Formula f;
  f.name = "disc_of_sun";
  f.args = {
      {"away", Kind::number, "", aways}, {"radius", Kind::number, "", discs}, {"pixel", Kind::number, "", pixels}};
  f.outputs = {{"part", 0}};
  f.made_from = one;
  f.fit = [](Json& args, Random& random) {
    const double edge = number(args, "radius") + random.between(-1.1, 1.1) * number(args, "pixel");
    if (edge > 0.0) args["away"] = edge;
  };
  return function_of(f);
}

Function glare_of_sun() {
  Formula f;
  f.name = "glare_of_sun";
  f.args = {
      {"away", Kind::number, "", aways}, {"radius", Kind::number, "", discs}, {"reach", Kind::number, "", {0.1, 1.0}}};
  f.outputs = {{"part", 0}};
  f.fit = [](Json& args, Random& random) {
    if (random.chance(0.9)) args["away"] = number(args, "reach") * random.log_between(1e-5, 1.01);
  };
  f.on_cpu = 8.0;
  f.on_gpu = 8.0;
  return function_of(f);
}

Function tone_map() {
  Formula f;
  f.name = "tone_map";
  f.args = {{"light", Kind::spread, "", {0.0, 65504.0}},
            {"curve", Kind::word, "", any, false, {"filmic", "reinhard", "linear"}}};
  f.outputs = {{"light", 0, 3}};
  f.fit = [](Json& args, Random& random) {
    for (Json& channel : args["light"]) {
      if (random.chance(0.9)) channel = random.log_between(1e-5, 65504.0);
    }
  };
  f.on_cpu = 8.0;
  f.on_gpu = 8.0;
  return function_of(f);
}

Function srgb() {
  Formula f;
  f.name = "srgb";
  f.args = {{"light", Kind::spread, "", {-1.0, 2.0}}};
  f.outputs = {{"color", 0, 3}};
  f.made_from = one;
  return function_of(f);
}

}  // namespace

std::vector<Function> sky_functions() {
  return {ring_opacity(),     ring_veil(),   star_light(),   band_brightness(), town_light(),
          tangent_from_sun(), disc_of_sun(), glare_of_sun(), tone_map(),        srgb()};
}

}  // namespace terrella::probe
