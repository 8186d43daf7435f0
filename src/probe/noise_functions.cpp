// Noise. Definitions and bounds of errors: docs/numerics.md.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/text.hpp"
#include "formulas/formulas.hpp"
#include "probe/table.hpp"

namespace terrella::probe {
namespace {

const std::vector<std::string_view> noise_kinds = {"simplex", "psrd", "fbm", "ridge", "flow", "worley"};
constexpr int kind_fbm = 2, kind_flow = 4, kind_worley = 5;

int kind_of_noise(const Json& args) {
  const auto found = std::find(noise_kinds.begin(), noise_kinds.end(), args["kind"].get<std::string>());
  return static_cast<int>(found - noise_kinds.begin());
}

// A whole number as what is left of it in 32 bits: there the lattice repeats.
unsigned wrapped(double whole) {
  const double rest = std::fmod(whole, 0x1p32);
  return static_cast<unsigned>(static_cast<long long>(rest));
}

Prepared prepare_noise(const Json& args) {
  const bool from_camera = has(args, "cam");
  if (from_camera != has(args, "q") || from_camera == has(args, "p")) {
    return Failure{"noise: a place is either p, or cam and q."};
  }
  const int kind = kind_of_noise(args);
  const bool layered = kind >= kind_fbm && kind <= kind_flow;
  const double turned = std::remainder(number_or(args, "alpha", 0.0), turn);
  const double strength = number_or(args, "warp", 0.5), lacunarity = number_or(args, "lacunarity", 2.0);
  const auto count = layered ? static_cast<int>(number_or(args, "octaves", 4.0)) : 1;
  const auto seed = static_cast<unsigned>(number_or(args, "seed", 0.0));
  Numbers numbers = {static_cast<double>(kind), static_cast<double>(count)};
  glm::dvec3 near = triple(args, from_camera ? "q" : "p");
  glm::dvec3 start = from_camera ? triple(args, "cam") : glm::dvec3(0.0);
  const auto reach = [&near] { return std::max({std::fabs(near.x), std::fabs(near.y), std::fabs(near.z)}); };
  // A place so far out that its cells would not fit into 32 bits is told from there.
  constexpr double kFar = 1e6, kMostCells = 1e9;
  if (reach() > kFar) {
    start += near;
    near = glm::dvec3(0.0);
  }
  if (const double cells = reach() * std::pow(lacunarity, count - 1); cells > kMostCells) {
    return Failure{text_of("noise: the finest octave is asked for ", cells, " cells away; at most ", kMostCells,
                           " can be told apart.")};
  }
  add(numbers, near);
  numbers.insert(numbers.end(), {std::cos(turned), std::sin(turned), number_or(args, "persistence", 0.5), strength});
  double frequency = 1.0;
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 offset = layered ? glm::dvec3(f64::layer_offset(i, seed)) : glm::dvec3(0.0);
    const glm::dvec3 place = start * frequency + offset;
    // The corner next to the place, of cubes or of the skewed lattice; simplex_of does the same.
    const bool cubes = kind == kind_worley;
    const glm::dvec3 cell = glm::floor(place + (cubes ? 0.0 : (place.x + place.y + place.z) / 3.0));
    const glm::dvec3 left = place - cell + (cubes ? 0.0 : (cell.x + cell.y + cell.z) / 6.0);
    for (const double part : {cell.x, cell.y, cell.z}) add_bits(numbers, wrapped(part));
    add(numbers, left);
    numbers.push_back(frequency);
    add_bits(numbers, layered ? f64::layer_seed(i, seed) : seed);
    frequency *= lacunarity;
  }
  return numbers;
}

Numbers allowed_noise(const Case& c) {
  // Each octave's place is known to u of itself, and its value to 6.5 times that, its gradient to 60 times.
  const double reach = std::max({std::fabs(c.numbers[2]), std::fabs(c.numbers[3]), std::fabs(c.numbers[4])});
  const int kind = static_cast<int>(c.numbers[0]);
  double amplitude = 1.0, total = 0.0, value = 0.0, slope = 0.0, stirred = 0.0;
  for (std::size_t at = 9; at < c.numbers.size(); at += 12) {
    const double frequency = c.numbers[at + 9], far = std::fmax(1.0, reach * frequency / 100.0);
    // What stirs an octave of flow noise is itself known so well only.
    const double place = stirred * std::fabs(c.numbers[8]);
    value += amplitude * (5e-4 * far + 6.5 * place);
    slope += amplitude * frequency * (2e-3 * far + 60.0 * place) * (kind == kind_flow ? 10.0 : 1.0);
    stirred += amplitude * 2e-3 * far;
    total += amplitude;
    amplitude *= c.numbers[7];
  }
  Numbers allowed = {value / total, slope / total, slope / total, slope / total, 5e-4};
  // Along the edges of ridges and between the points of cells the gradient jumps.
  const bool jumps = kind == 3 || kind == kind_worley;
  for (std::size_t i = 1; i < 4 && jumps; ++i) allowed[i] = anything;
  return allowed;
}

Function noise() {
  Function f;
  f.name = "noise";
  const Range count{1.0, 24.0}, seeds{0.0, 4294967295.0}, lacunarities{1.0, 4.0}, persistences{0.0, 1.5},
      warps{-10.0, 10.0};
  f.args = {{"kind", Kind::word, "", any, false, noise_kinds},
            of_host({"p", Kind::triple, "cells", any, true}),
            of_host({"cam", Kind::triple, "cells", any, true}),
            {"q", Kind::triple, "cells", any, true},
            of_host({"alpha", Kind::number, "rad", any, true}),
            of_host({"seed", Kind::whole, "", seeds, true}),
            of_host({"octaves", Kind::whole, "", count, true}),
            of_host({"lacunarity", Kind::number, "", lacunarities, true}),
            {"persistence", Kind::number, "", persistences, true},
            {"warp", Kind::number, "", warps, true}};
  f.prepare = prepare_noise;
  f.shape = [](const Json& args, std::span<const double>) {
    std::vector<Output> outputs = {{"n", 0}, {"grad", 1, 3}};
    if (kind_of_noise(args) == kind_worley) outputs.push_back({"F2", 4});
    return outputs;
  };
  f.random = [](Random& random) {
    const auto place = [&](double half) {
      const double x = random.between(-half, half), y = random.between(-half, half);
      return glm::dvec3(x, y, random.between(-half, half));
    };
    Json args = {{"kind", noise_kinds[random.below(noise_kinds.size())]}};
    if (random.chance(0.3)) {
      args["cam"] = list(place(random.log_between(1.0, 1e7)));
      args["q"] = rounded(place(20.0));
    } else {
      args["p"] = rounded(place(random.chance(0.5) ? 2.0 : 100.0));
    }
    args["alpha"] = random.between(-10.0, 10.0);
    args["seed"] = static_cast<double>(random.below(1'000'000));
    args["octaves"] = static_cast<double>(1 + random.below(8));
    args["lacunarity"] = rounded(random.between(1.5, 2.5));
    args["persistence"] = rounded(random.between(0.2, 0.7));
    args["warp"] = rounded(random.between(0.0, 0.2));
    return args;
  };
  f.allowed = allowed_noise;
  return f;
}

}  // namespace

std::vector<Function> noise_functions() { return {noise()}; }

}  // namespace terrella::probe
