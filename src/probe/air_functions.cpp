// Light in air and clouds. Definitions and bounds of errors: docs/numerics.md.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/text.hpp"
#include "formulas/formulas.hpp"
#include "probe/table.hpp"

namespace terrella::probe {
namespace {

Function phase() {
  Function f;
  f.name = "phase";
  f.args = {{"kind", Kind::word, "", any, false, {"hg", "rayleigh"}},
            {"mu", Kind::number, "", {-1.001, 1.001}},
            {"g", Kind::number, "", {-1.0, 1.0, true}, true}};
  f.outputs = {{"p", 0}};
  f.prepare = [](const Json& args) -> Prepared {
    const bool haze = args["kind"] == "hg";
    if (haze && !has(args, "g")) return Failure{"phase: the argument g is missing; it is a number, -1 to 1."};
    return Numbers{haze ? 1.0 : 0.0, number(args, "mu"), number_or(args, "g", 0.0)};
  };
  f.random = [](Random& random) {
    const double near_end = 1.0 - random.log_between(1e-7, 1.0);
    const double mu = (random.chance(0.5) ? 1.0 : -1.0) * (random.chance(0.1) ? 1.0 : near_end);
    const double g = random.chance(0.1) ? 0.9999 : 1.0 - random.log_between(1e-4, 1.0);
    return Json{{"kind", random.chance(0.7) ? "hg" : "rayleigh"},
                {"mu", rounded(mu)},
                {"g", rounded(random.chance(0.5) ? -g : g)}};
  };
  f.allowed = relative(12.0, 40.0);
  return f;
}

Function beer_lambert() {
  Function f;
  f.name = "beer_lambert";
  f.args = {{"sigma", Kind::number, "1/m", not_negative}, {"dist", Kind::number, "m", not_negative}};
  f.outputs = {{"T", 0}, {"absorbed", 1}, {"mean", 2}};
  f.prepare = as_they_come({"sigma", "dist"});
  f.random = [](Random& random) {
    const double depth = random.chance(0.05) ? 0.0 : random.log_between(1e-12, 700.0);
    // Now and then up to where a float ends for the one or the other.
    const double shortest = std::fmax(2e-38, 4e-39 * depth), longest = std::fmin(3e38, 5e37 * std::fmax(depth, 1e-12));
    const double dist =
        random.chance(0.7) ? random.log_between(1e-3, 1e6) : rounded(random.log_between(shortest, longest));
    return Json{{"sigma", rounded(depth / dist)}, {"dist", rounded(dist)}};
  };
  f.allowed = [](const Case& c) {
    // Drivers take the exponential by powers of two, whose exponent is a product known to u of itself.
    const double driver = c.gpu ? 8.0 * u * c.numbers[0] * c.numbers[1] : 0.0;
    return Numbers{(8.0 * u + driver) * c.answers[0] + faint, 8.0 * u * c.answers[1] + faint,
                   8.0 * u * c.answers[2] + faint};
  };
  return f;
}

// Air of the earth (Bruneton 2017), for what is not given.
struct Air {
  const char* name;
  const char* unit;
  Range range;
  bool colored;
  glm::dvec3 earth;
};

const Air airs[] = {
    {"bottom", "m", positive, false, glm::dvec3(6.36e6)},
    {"top", "m", positive, false, glm::dvec3(6.42e6)},
    {"rayleigh", "1/m", not_negative, true, {5.802e-6, 13.558e-6, 33.1e-6}},
    {"rayleigh_H", "m", positive, false, glm::dvec3(8000.0)},
    {"mie", "1/m", not_negative, true, glm::dvec3(4.44e-6)},
    {"mie_H", "m", positive, false, glm::dvec3(1200.0)},
    {"ozone", "1/m", not_negative, true, {0.65e-6, 1.881e-6, 0.085e-6}},
    {"ozone_center", "m", any, false, glm::dvec3(25000.0)},
    {"ozone_half", "m", positive, false, glm::dvec3(15000.0)},
};

Arg air_argument() {
  Arg arg{"atm", Kind::object, "", any, true};
  for (const Air& air : airs) {
    arg.fields.push_back({air.name, air.colored ? Kind::spread : Kind::number, air.unit, air.range, true});
  }
  return of_host(arg);
}

// A sentence where two directions with the given cosines to up can't be at the angle whose cosine is nu. Each cosine
// may be off by what rounding it to single precision moves it by.
std::string trouble_with_nu(double mu, double mu_s, double nu) {
  const auto half_range = [&](double slack) {
    return std::sqrt((1.0 - mu * mu + slack) * (1.0 - mu_s * mu_s + slack)) + slack;
  };
  const double middle = mu * mu_s, half = half_range(0.0);
  if (std::fabs(nu - middle) <= half_range(4.0 * u)) return {};
  return text_of("single_scatter: nu is ", nu, ", but between a ray of mu ", mu, " and a sun of mu_s ", mu_s, " it is ",
                 middle - half, " to ", middle + half, ".");
}

// A sentence where a ray from an altitude meets the ground: by more than rounding, whose air would be as dense as none.
std::string trouble_with_ground(const Numbers& numbers) {
  const double alt = numbers[0], mu = numbers[1], bottom = numbers[2];
  if (mu >= 0.0) return {};
  const double lowest = (bottom + alt) * std::sqrt((1.0 - mu) * (1.0 + mu)) - bottom;
  if (lowest >= std::fmin(alt, 0.0) - 1e-6 * bottom) return {};
  return text_of("transmittance: with mu ", mu, " the ray from alt ", alt, " meets the ground, ", -lowest,
                 " under it at its lowest; it has to pass.");
}

// Adds the numbers of an air, in the order of lib/scattering.glsl. Returns a sentence where they contradict each other.
std::string add_air(Numbers& numbers, const Json& given, double alt) {
  double bottom = 0.0;
  for (const Air& air : airs) {
    const glm::dvec3 value = has(given, air.name) ? triple(given, air.name) : air.earth;
    const std::string_view name = air.name;
    if (name == "bottom") bottom = value.x;
    if (air.colored) {
      add(numbers, value);
    } else {
      numbers.push_back(name == "top" ? value.x - bottom : value.x);
    }
    if (name == "top" && !(value.x > bottom)) {
      return text_of("atm: top is ", value.x, " and bottom is ", bottom, "; the top lies above the bottom.");
    }
  }
  if (!(bottom + alt > 0.0)) return text_of("alt: ", alt, " is the planet's centre or beyond it.");
  return {};
}

// A path through the air of the earth that meets no ground, or, rarely, through thinner or smaller ones.
Json random_air(Random& random) {
  if (random.chance(0.7)) return Json::object();
  const double size = random.log_between(1e-2, 10.0);
  return Json{{"bottom", 6.36e6 * size},
              {"top", 6.36e6 * size + 6e4},
              {"rayleigh", list(glm::dvec3(5.8e-6, 13.5e-6, 33e-6) * random.between(0.0, 2.0))},
              {"rayleigh_H", random.between(5000.0, 12000.0)},
              {"mie", 4.4e-6 * random.between(0.0, 5.0)},
              {"mie_H", random.between(800.0, 3000.0)}};
}

double bottom_of(const Json& air) { return has(air, "bottom") ? number(air, "bottom") : 6.36e6; }

// The cosine with the zenith of the horizon.
double lowest_ray(double bottom, double alt) { return -std::sqrt(alt * (2.0 * bottom + alt)) / (bottom + alt); }

Function transmittance() {
  Function f;
  f.name = "transmittance";
  f.args = {{"alt", Kind::number, "m"}, {"mu", Kind::number, "", {-1.0, 1.0}}, air_argument()};
  f.outputs = {{"T", 0, 3}, {"tau", 3, 3}};
  f.prepare = [](const Json& args) -> Prepared {
    Numbers numbers = {number(args, "alt"), number(args, "mu")};
    if (std::string trouble = add_air(numbers, args.value("atm", Json::object()), numbers[0]); !trouble.empty())
      return Failure{trouble};
    if (std::string trouble = trouble_with_ground(numbers); !trouble.empty()) return Failure{trouble};
    return numbers;
  };
  f.random = [](Random& random) {
    const Json air = random_air(random);
    const double alt = random.chance(0.1)
                           ? 0.0
                           : rounded(random.chance(0.5) ? random.between(0.0, 6e4) : random.log_between(1e-1, 6e4));
    const double lowest = lowest_ray(bottom_of(air), alt);
    const double mu = random.chance(0.2) ? 0.0 : lowest + (1.0 - lowest) * random.log_between(1e-4, 1.0);
    return Json{{"alt", alt}, {"mu", rounded(mu)}, {"atm", air}};
  };
  f.allowed = [](const Case& c) {
    Numbers allowed(6, c.gpu ? 4e-3 : 1e-5);
    for (std::size_t i = 3; i < 6; ++i) allowed[i] = 3e-5 * c.answers[i] + faint;
    return allowed;
  };
  f.rarity = 4;
  return f;
}

Function single_scatter() {
  Function f;
  f.name = "single_scatter";
  f.args = {{"alt", Kind::number, "m"},
            {"mu", Kind::number, "", {-1.0, 1.0}},
            {"mu_s", Kind::number, "", {-1.0, 1.0}},
            {"nu", Kind::number, "", {-1.0, 1.0}},
            {"dist", Kind::number, "m", not_negative},
            {"mie_scattering", Kind::spread, "1/m", not_negative},
            air_argument()};
  f.outputs = {{"R", 0, 3}, {"M", 3, 3}};
  f.prepare = [](const Json& args) -> Prepared {
    Numbers numbers;
    for (const char* name : {"alt", "mu", "mu_s", "nu", "dist"}) numbers.push_back(number(args, name));
    if (std::string trouble = trouble_with_nu(numbers[1], numbers[2], numbers[3]); !trouble.empty()) {
      return Failure{trouble};
    }
    add(numbers, triple(args, "mie_scattering"));
    if (std::string trouble = add_air(numbers, args.value("atm", Json::object()), numbers[0]); !trouble.empty())
      return Failure{trouble};
    return numbers;
  };
  f.random = [](Random& random) {
    const Json air = random_air(random);
    const double bottom = bottom_of(air);
    const double alt = rounded(random.chance(0.5) ? random.log_between(1.0, 5e4) : random.between(10.0, 5.9e4));
    const double mu = rounded(random.between(-1.0, 1.0));
    const double low = random.chance(0.3) ? -0.3 : -0.1;
    const double mu_s = rounded(random.between(low, 1.0) * (random.chance(0.4) ? 0.2 : 1.0));
    const double side = std::sqrt((1.0 - mu * mu) * (1.0 - mu_s * mu_s));
    const double nu = rounded(mu * mu_s + side * std::cos(random.between(0.0, std::numbers::pi)));
    // As far as the ground or the top.
    const f64::Roots ground = f64::ray_shell(bottom, alt, mu, 0.0), top = f64::ray_shell(bottom, alt, mu, 6e4);
    const double whole = mu < 0.0 && ground.met ? ground.t0 : top.t1;
    const double dist = random.chance(0.5) ? whole : whole * random.log_between(1e-5, 1.0);
    return Json{{"alt", alt},
                {"mu", mu},
                {"mu_s", mu_s},
                {"nu", nu},
                {"dist", rounded(dist * (1.0 - 1e-6))},
                {"mie_scattering", 3.996e-6},
                {"atm", air}};
  };
  f.allowed = [](const Case& c) {
    const double part = c.gpu ? 2e-2 : 2e-3;
    const double air = part * std::max({c.answers[0], c.answers[1], c.answers[2]}) + 1e-12;
    const double haze = part * std::max({c.answers[3], c.answers[4], c.answers[5]}) + 1e-12;
    return Numbers{air, air, air, haze, haze, haze};
  };
  f.rarity = 100;
  return f;
}

Function cloud_signal() {
  Function f;
  f.name = "cloud_signal";
  f.args = {{"alt", Kind::number, "m"}, {"bottom", Kind::number, "m"}, {"top", Kind::number, "m"}};
  f.outputs = {{"h", 0}};
  f.prepare = [](const Json& args) -> Prepared {
    const double bottom = number(args, "bottom"), top = number(args, "top");
    if (!(top > bottom)) {
      return Failure{
          text_of("cloud_signal: top is ", top, " and bottom is ", bottom, "; the top lies above the bottom.")};
    }
    return as_they_come({"alt", "bottom", "top"})(args);
  };
  f.random = [](Random& random) {
    const double bottom = stretched(random, 1.0, 1e4), top = bottom + stretched(random, 100.0, 1e5);
    const double alt = bottom + (top - bottom) * random.between(-0.1, 1.1);
    return Json{{"alt", rounded(random.chance(0.1) ? top : alt)}, {"bottom", bottom}, {"top", rounded(top)}};
  };
  f.allowed = absolute(6.0, 6.0);
  return f;
}

Function cloud_march() {
  Function f;
  f.name = "cloud_march";
  f.args = {{"density", Kind::numbers},
            {"step", Kind::number, "m", not_negative},
            {"E", Kind::number, "1/m", not_negative},
            {"S", Kind::number, "1/m", not_negative},
            {"phase", Kind::number, "1/sr", not_negative},
            {"I_sun", Kind::number, "", not_negative}};
  f.outputs = {{"T", 0}, {"I", 1}};
  f.prepare = [](const Json& args) -> Prepared {
    Numbers numbers;
    for (const char* name : {"step", "E", "S", "phase", "I_sun"}) numbers.push_back(number(args, name));
    numbers.push_back(static_cast<double>(args["density"].size()));
    for (const Json& value : args["density"]) numbers.push_back(value.get<double>());
    return numbers;
  };
  f.random = [](Random& random) {
    Json density = Json::array();
    const std::size_t count = random.below(101);
    for (std::size_t i = 0; i < count; ++i) density.push_back(rounded(random.between(-1.0, 1.0)));
    return Json{{"density", density},
                {"step", rounded(random.log_between(1.0, 1e3))},
                {"E", rounded(random.log_between(1e-6, 0.1))},
                {"S", rounded(random.log_between(1e-6, 0.1))},
                {"phase", rounded(random.log_between(1e-3, 10.0))},
                {"I_sun", rounded(random.log_between(1e-2, 1e3))}};
  };
  f.allowed = [](const Case& c) {
    double depth = 0.0;
    for (std::size_t i = 6; i < c.numbers.size(); ++i)
      depth += c.numbers[0] * c.numbers[1] * std::fmax(c.numbers[i], 0.0);
    const double bound = 2.0 * (c.numbers[5] + 8.0 + 2.0 * depth) * u;
    return Numbers{bound * c.answers[0] + faint, bound * c.answers[1] + faint};
  };
  return f;
}

Function march() {
  Function f;
  f.name = "march";
  f.args = {{"segments", Kind::objects, "", any, false, {}, {{"TA"}, {"IA"}, {"TC"}, {"IC"}}}};
  f.outputs = {{"T", 0}, {"I", 1}};
  f.prepare = [](const Json& args) -> Prepared {
    Numbers numbers = {static_cast<double>(args["segments"].size())};
    for (const Json& segment : args["segments"]) {
      for (const char* name : {"TA", "IA", "TC", "IC"}) numbers.push_back(number(segment, name));
    }
    return numbers;
  };
  f.random = [](Random& random) {
    Json segments = Json::array();
    const std::size_t count = random.below(257);
    for (std::size_t i = 0; i < count; ++i) {
      segments.push_back({{"TA", rounded(random.between(0.9, 1.0))},
                          {"IA", rounded(random.between(0.0, 1.0))},
                          {"TC", rounded(random.chance(0.5) ? 1.0 : random.between(0.0, 1.0))},
                          {"IC", rounded(random.between(0.0, 10.0))}});
    }
    return Json{{"segments", segments}};
  };
  f.allowed = [](const Case& c) {
    const double bound = 2.0 * (c.numbers[0] + 4.0) * u;
    return Numbers{bound * std::fabs(c.answers[0]) + faint, bound * std::fabs(c.answers[1]) + faint};
  };
  return f;
}

}  // namespace

std::vector<Function> air_functions() {
  return {phase(), beer_lambert(), transmittance(), single_scatter(), cloud_signal(), cloud_march(), march()};
}

}  // namespace terrella::probe
