// The ground of the picture, its waves and its colour. Definitions and bounds of errors: docs/numerics.md.
#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "formulas/formulas.hpp"
#include "probe/evaluate.hpp"
#include "probe/map_argument.hpp"
#include "probe/scene_arguments.hpp"

namespace terrella::probe {
namespace {

// The finest layers of noise have half a cell between such samples: there noise still knows where it is.
constexpr Range footprints{1e-6, 1.0};

// What a weight of layers leaves of 1 is known to so much, as faint as it may be.
constexpr double weight = 4.0 * u;

// The layers of the ground are the numbers from 4 on, as read_terrain reads them.
Formula formula_of_heights(std::string_view name) {
  Formula f;
  f.name = name;
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
  f.on_cpu = 32.0;
  f.on_gpu = 32.0;
  return f;
}

// What bounds of heights take of a case: its body puts two more answers for them than requests are told.
struct HeightCase {
  f64::Terrain terrain{};  // those of its members that matter to bounds
  double footprint;
  double mean, shape;  // as Height has them

  explicit HeightCase(const Case& c) : footprint(c.numbers[3]), mean(c.answers[5]), shape(c.answers[6]) {
    terrain.height = c.numbers[4];
    terrain.frequency = c.numbers[5];
    terrain.octaves = static_cast<int>(c.numbers[6]);
    terrain.lacunarity = c.numbers[8];
    terrain.power = c.numbers[9];
    terrain.ridged = c.numbers[10] > 0.5;
    terrain.sharpness = c.numbers[11];
  }

  // To so much a mean of layers is known.
  [[nodiscard]] double known() const { return (12.0 + terrain.octaves) * u; }

  // Slopes of ridges change so much faster at their edges.
  [[nodiscard]] double edge_of(bool ridged) const { return ridged ? 1.0 + terrain.sharpness : 1.0; }
};

void allow_slope(Numbers& allowed, double slope) {
  for (std::size_t i = 1; i < 4; ++i) allowed[i] += slope;
}

// Openness rises by no more with what it is told of.
constexpr double openness_of_relief = 5.0;

// Noise itself is known no better than to some u, however slowly it changes; ridges multiply that at their edges. rise:
// of the height with a mean of layers; of_relief: the same of what openness is told of.
void allow_noise(Numbers& allowed, const HeightCase& of, double rise, double of_relief, bool ridged) {
  const f64::Terrain& t = of.terrain;
  const double steep = of.known() * t.frequency;
  // Layers that are nearly too fine to be shown have half a cell a footprint.
  const double finest = t.frequency * std::pow(t.lacunarity, t.octaves - 1.0), last = 0.5 / of.footprint;
  constexpr double steepest = 16.0;  // of noise, a cell
  const double faded = finest > 0.8 * last ? weight * last : 0.0;
  allowed[0] += of.known() * rise;
  allow_slope(allowed, (of.edge_of(ridged) * steep + steepest * faded) * rise);
  allowed[4] += openness_of_relief * (steep + faded) * of_relief;
}

// Openness is a half and what is added to it; where it is hardly known, as much may make a hollow of a crest.
void allow_openness(Numbers& allowed) {
  allowed[4] += 8.0 * u;
  if (allowed[4] > 0.1) allowed[4] = anything;
}

// Where the ground ends in a plain at its lowest or highest, slopes jump. part: 0 and 1 there, known to so much.
void allow_plains(Numbers& allowed, double part, double known) {
  if (part <= known || part >= 1.0 - known) std::fill(allowed.begin() + 1, allowed.end(), anything);
}

// All amplitudes as a multiple of those of the ridges of ranges; 0 without ridges.
double layers_for_ridges(const Case& c) {
  const auto octaves = static_cast<int>(c.numbers[6]), first = static_cast<int>(c.numbers[15]);
  if (c.numbers[14] == 0.0 || first >= octaves) return 0.0;
  const double all = f64::amplitude_sum(c.numbers[7], octaves);
  return all / (all - f64::amplitude_sum(c.numbers[7], first));
}

// The slope of the mean of all layers.
double slope_of_mean(const Case& c) {
  Numbers plain(c.numbers.begin(), c.numbers.end());
  plain[4] = plain[9] = 1.0;  // H and p
  plain[14] = 0.0;            // the part of ranges
  const Answers<double> mean = evaluate_f64("terrain_height", plain);
  return std::hypot(mean[1], mean[2], mean[3]);
}

// At the foot of ranges the rise itself changes fast with the mean of layers, which is known to some u. layers: as
// layers_for_ridges has it.
void allow_feet(Numbers& allowed, const HeightCase& of, double layers, double slope_of_mean) {
  const f64::Relief here = f64::relief_of(of.terrain, of.mean, of.shape);
  const auto of_relief = [layers](const f64::Relief& at) { return at.by_mean + layers * at.by_shape; };
  double rise = 0.0, relief = 0.0;  // off by so much
  for (const double off : {-of.known(), of.known()}) {
    const f64::Relief beside = f64::relief_of(of.terrain, of.mean + off, of.shape);
    rise = std::fmax(rise, std::fabs(beside.by_mean - here.by_mean));
    relief = std::fmax(relief, std::fabs(of_relief(beside) - of_relief(here)));
  }
  allow_slope(allowed, rise * slope_of_mean);
  constexpr double most = 0.2;  // that openness rises by with the logarithm of what it is told of
  allowed[4] += most * relief / std::fmax(of_relief(here), faint);
}

Function terrain_height() {
  Formula f = formula_of_heights("terrain_height");
  f.args.push_back({"ranges",
                    Kind::object,
                    "",
                    any,
                    true,
                    {},
                    {{"part", Kind::number, "", parts},
                     {"first", Kind::whole, "", {0.0, 24.0}},
                     {"low", Kind::number, "", parts, true}}});
  f.fit = [](Json& args, Random& random) {
    // Ridges of a smaller part of all layers are so steep that single precision holds no squares of it.
    constexpr double faintest = 1e-9;
    if (std::pow(number(args, "persistence"), number(args["ranges"], "first")) < faintest) args["ranges"]["first"] = 0;
    if (random.chance(0.5)) args.erase("ranges");
  };
  f.rarity = 10;
  Function made = function_of(f);
  made.prepare = [of_all = made.prepare](const Json& args) {
    Json all = args;
    if (!has(args, "ranges")) all["ranges"] = {{"part", 0.0}, {"first", 0}};
    if (all["ranges"].is_object() && !has(all["ranges"], "low")) all["ranges"]["low"] = 0.0;
    return of_all(all);
  };
  made.allowed = [of_arguments = made.allowed](const Case& c) {
    Numbers allowed = of_arguments(c);
    HeightCase of(c);
    of.terrain.ranges = {c.numbers[14], static_cast<int>(c.numbers[15]), c.numbers[16]};
    const f64::Relief relief = f64::relief_of(of.terrain, of.mean, of.shape);
    const double layers = layers_for_ridges(c);
    allow_noise(allowed, of, relief.by_mean, relief.by_mean, of.terrain.ridged);
    allow_noise(allowed, of, relief.by_shape, relief.by_shape * layers, true);
    if (layers > 0.0) allow_feet(allowed, of, layers, slope_of_mean(c));
    allow_openness(allowed);
    allow_plains(allowed, of.mean, of.known());
    return allowed;
  };
  return made;
}

Function mapped_height() {
  Formula f = formula_of_heights("mapped_height");
  f.rarity = 50;
  Function made = function_of(f);
  made.args.push_back(map_argument());
  made.map = map_of_argument;
  made.random = [of_rest = made.random](Random& random) {
    Json args = of_rest(random);
    args["map"] = made_up_map(random);
    return args;
  };
  made.allowed = [of_arguments = made.allowed](const Case& c) {
    Numbers allowed = of_arguments(c);
    const HeightCase of(c);
    const f64::Relief relief = f64::mapped_relief_of(of.terrain, of.mean, of.shape);
    allow_noise(allowed, of, relief.by_mean, relief.by_mean, of.terrain.ridged);
    // A map is known to some u of its highest. Rows are compared for slopes, and levels for openness, of hills as wide
    // as three texels.
    allow_slope(allowed, 4.0 * u * relief.by_shape * c.map->levels()[0].height / (0.5 * turn));
    allowed[4] += openness_of_relief * 8.0 * u * of.terrain.height / (3.0 * c.map->texel());
    allow_openness(allowed);
    allow_plains(allowed, of.shape + f64::mapped_rise(of.shape, of.terrain.power) * of.mean, of.known());
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

std::vector<Function> ground_functions() {
  return {terrain_height(), mapped_height(), craters(), swell(), ground_albedo()};
}

}  // namespace terrella::probe
