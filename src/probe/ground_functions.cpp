// The ground of the picture, its waves and its colour. Definitions and bounds of errors: docs/numerics.md.
#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "formulas/formulas.hpp"
#include "probe/scene_arguments.hpp"

namespace terrella::probe {
namespace {

// The finest layers of noise have half a cell between such samples: there noise still knows where it is.
constexpr Range footprints{1e-6, 1.0};

// What a weight of layers leaves of 1 is known to so much, as faint as it may be.
constexpr double weight = 4.0 * u;

Function terrain_height() {
  Formula f;
  f.name = "terrain_height";
  f.args = {{"direction", Kind::triple, "", components},
            {"footprint", Kind::number, "rad", footprints},
            {"H", Kind::number, "radii", parts},
            {"frequency", Kind::number, "cells/radius", {0.01, 1e4}},
            {"octaves", Kind::whole, "", {0.0, 24.0}},
            {"persistence", Kind::number, "", {0.0, 1.5}},
            {"lacunarity", Kind::number, "", {1.0, 4.0}},
            {"p", Kind::number, "", {0.0, 16.0}},
            {"mode", Kind::word, "", any, false, {"fbm", "ridge"}},
            {"k", Kind::number, "", {0.0, 1000.0}},
            of_host({"seed", Kind::whole, "", seeds})};
  f.outputs = {{"height", 0}, {"grad", 1, 3}, {"openness", 4}};
  f.rarity = 10;
  f.on_cpu = 32.0;
  f.on_gpu = 32.0;
  Function made = function_of(f);
  made.allowed = [of_arguments = made.allowed](const Case& c) {
    Numbers allowed = of_arguments(c);
    allowed[4] += 8.0 * u;  // openness is a half and what is added to it
    const double H = c.numbers[4], p = c.numbers[9];
    if (allowed[4] > 0.1) allowed[4] = anything;  // as much may make a hollow of a crest
    // Where the mean of the layers reaches 0 or 1 the ground ends in a plain: its slope jumps.
    const double h = std::pow(c.answers[0] / std::fmax(H, faint), 1.0 / std::fmax(p, 1e-3));
    const double known = (12.0 + c.numbers[6]) * u;
    // Noise itself is known no better than to some u, however slowly it changes; ridges multiply that at their edges.
    const double steepened = f64::height_power_slope(h, H, p);
    const double edge = c.numbers[10] > 0.5 ? 1.0 + c.numbers[11] : 1.0;
    double slope = known * edge * c.numbers[5] * steepened;
    allowed[0] += known * steepened;
    // Layers that are nearly too fine to be shown have half a cell a footprint; noise is at most so steep.
    const double finest = c.numbers[5] * std::pow(c.numbers[8], c.numbers[6] - 1.0), last = 0.5 / c.numbers[3];
    constexpr double steepest = 16.0;
    if (finest > 0.8 * last) slope += weight * steepest * last * steepened;
    for (std::size_t i = 1; i < 4; ++i) allowed[i] += slope;
    if (h <= known || h >= 1.0 - known) std::fill(allowed.begin() + 1, allowed.end(), anything);
    return allowed;
  };
  return made;
}

// Whether some centre near a place is as far from the sphere as craters may be: then rounding decides of a crater
// whether it is there.
bool has_doubtful_crater(const Case& c, double known) {
  const glm::dvec3 direction(c.numbers[0], c.numbers[1], c.numbers[2]);
  const unsigned seed = static_cast<unsigned>(c.numbers[7]) << 16U | static_cast<unsigned>(c.numbers[8]);
  double frequency = c.numbers[5];
  for (int i = 0; i < static_cast<int>(c.numbers[6]); ++i) {
    const glm::ivec3 cell(glm::floor(direction * frequency - 0.5));
    for (int k = 0; k < 8; ++k) {
      const glm::ivec3 corner = cell + glm::ivec3(k & 1, (k >> 1) & 1, k >> 2);
      const glm::dvec3 dice = f64::hash_parts(f64::hash_cell(corner, f64::crater_seed(i, seed))) / 1023.0;
      const glm::dvec3 centre = glm::dvec3(corner) + dice;
      const double from_origin = glm::length(centre), from_sphere = std::fabs(from_origin - frequency);
      const bool near = glm::distance(centre / from_origin, direction) * frequency < 0.5;
      if (near && std::fabs(from_sphere - f64::crater_shell) < known * frequency) return true;
    }
    frequency *= f64::crater_step;
  }
  return false;
}

Function craters() {
  Formula f;
  f.name = "craters";
  f.args = {{"direction", Kind::triple, "", components}, {"footprint", Kind::number, "rad", footprints},
            {"depth", Kind::number, "", parts},          {"frequency", Kind::number, "cells/radius", {0.01, 1e3}},
            {"sizes", Kind::whole, "", {0.0, 16.0}},     of_host({"seed", Kind::whole, "", seeds})};
  f.outputs = {{"height", 0}, {"grad", 1, 3}};
  f.rarity = 10;
  f.on_cpu = 16.0;
  f.on_gpu = 16.0;
  Function made = function_of(f);
  made.allowed = [of_arguments = made.allowed](const Case& c) {
    Numbers allowed = of_arguments(c);
    const double depth = weight * c.numbers[4];
    allowed[0] += depth / c.numbers[5];
    for (std::size_t i = 1; i < 4; ++i) allowed[i] += depth;
    if (has_doubtful_crater(c, 16.0 * u)) std::fill(allowed.begin(), allowed.end(), anything);
    return allowed;
  };
  return made;
}

Function swell() {
  Formula f;
  f.name = "swell";
  f.args = {{"v", Kind::triple, "", components},
            {"waves",
             Kind::objects,
             "",
             any,
             false,
             {},
             {{"origin", Kind::triple, "", components},
              {"A", Kind::number, "radii", {0.0, 0.2}},
              {"w", Kind::number, "rad/rad", {1.0, 1e6}},
              {"phase", Kind::number, "rad", {-turn / 2.0, turn / 2.0}},
              {"pinch", Kind::number, "radii", {0.0, 0.2}}}}};
  f.outputs = {{"height", 0}, {"shift", 1, 3}, {"slope", 4, 3}};
  f.rarity = 3;
  f.on_cpu = 8.0;
  f.on_gpu = 8.0;
  return function_of(f);
}

Function ground_albedo() {
  Formula f;
  f.name = "ground_albedo";
  constexpr Range heights{0.0, 1.0};
  f.args = {{"up", Kind::triple, "", components},
            {"normal", Kind::triple, "", components},
            {"grad", Kind::triple, "", {-1.0, 1.0}},
            {"openness", Kind::number, "", parts},
            {"height", Kind::number, "radii", {-1.0, 1.0}},
            {"bands",
             Kind::object,
             "",
             any,
             false,
             {},
             {{"sand", Kind::spread, "", parts},
              {"land", Kind::spread, "", parts},
              {"mountain", Kind::spread, "", parts},
              {"snow", Kind::spread, "", parts},
              {"seabed", Kind::spread, "", parts},
              {"sea", Kind::spread, "", parts},
              {"sand_height", Kind::number, "radii", heights},
              {"mountain_height", Kind::number, "radii", heights},
              {"snow_height", Kind::number, "radii", heights},
              {"softness", Kind::number, "", parts},
              {"slope_rock", Kind::number, "", parts},
              {"thinning", Kind::number, "", parts},
              {"snow_sine", Kind::number, "", {0.0, 2.0}},
              {"hollows", Kind::number, "", parts}}}};
  f.outputs = {{"albedo", 0, 3}};
  f.made_from = [](std::span<const double>) { return 1.0; };
  f.fit = [](Json& args, Random& random) {
    // Normals mostly point up, and all sorts of heights come near the bands'.
    const glm::dvec3 up = triple(args, "up");
    if (random.chance(0.8)) {
      const glm::dvec3 n = up + random.between(0.0, 1.0) * triple(args, "normal");
      args["normal"] = list(n / std::hypot(n.x, n.y, n.z));
    }
    if (random.chance(0.5)) {
      Json& bands = args["bands"];
      for (const char* name : {"sand_height", "mountain_height", "snow_height"}) {
        bands[name] = random.log_between(1e-6, 1.0);
      }
      args["height"] = number(bands, random.chance(0.5) ? "snow_height" : "sand_height") * random.between(-1.0, 2.0);
      if (number(args, "height") > 1.0) args["height"] = 1.0;
    }
  };
  f.rarity = 4;
  return function_of(f);
}

}  // namespace

std::vector<Function> ground_functions() { return {terrain_height(), craters(), swell(), ground_albedo()}; }

}  // namespace terrella::probe
