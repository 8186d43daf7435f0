// Waves, told from an anchor. Definitions and bounds of errors: docs/numerics.md.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/text.hpp"
#include "formulas/formulas.hpp"
#include "probe/table.hpp"

namespace terrella::probe {
namespace {

// Numbers of one wave, as it is told from an anchor. In extended precision, where there is any: for a wave of a
// millimetre on a planet of real size an arc known to a double's last place is a phase known to 1e-5.
struct LongVector {
  long double x, y, z;
};

LongVector unit(const glm::dvec3& v) {
  const long double size =
      std::hypot(static_cast<long double>(v.x), static_cast<long double>(v.y), static_cast<long double>(v.z));
  return {v.x / size, v.y / size, v.z / size};
}

long double dot(const LongVector& a, const LongVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

LongVector cross(const LongVector& a, const LongVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

glm::dvec3 rounded_down(const LongVector& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

Prepared prepare_gerstner(const Json& args) {
  const glm::dvec3 place = triple(args, "anchor");
  if (!(glm::length(place) > 0.0)) return Failure{"gerstner: anchor is 0 and so has no direction."};
  const double r = number(args, "r"), t = number(args, "t");
  const LongVector a = unit(place);
  Numbers numbers;
  add(numbers, triple(args, "q"));
  add(numbers, rounded_down(a));
  double from = 0.0, to = 0.0;
  if (has(args, "fade")) {
    from = args["fade"][0].get<double>();
    to = args["fade"][1].get<double>();
    if (!(from < to)) {
      return Failure{text_of("fade: [", from, ", ", to, "] does not rise; its first number is less than its second.")};
    }
  }
  const Json& waves = args["waves"];
  numbers.insert(numbers.end(), {r, from, to, static_cast<double>(waves.size())});
  const long double whole_turn = 2.0L * std::numbers::pi_v<long double>;
  for (std::size_t i = 0; i < waves.size(); ++i) {
    const glm::dvec3 from_where = triple(waves[i], "o");
    if (!(glm::length(from_where) > 0.0)) return Failure{text_of("waves[", i, "]: o is 0 and so has no direction.")};
    const LongVector o = unit(from_where);
    const long double cosine = dot(a, o);
    const LongVector difference =
        cosine < 0.0L ? LongVector{a.x + o.x, a.y + o.y, a.z + o.z} : LongVector{a.x - o.x, a.y - o.y, a.z - o.z};
    // a x o, of the length of the sine; the tangent at a away from o is a x (a x o).
    const LongVector aside = cross(difference, o);
    const long double sine = std::sqrt(dot(aside, aside));
    glm::dvec3 outward = f64::perpendicular(rounded_down(a));
    if (sine > 0.0L) {
      const LongVector across = cross(a, aside);
      outward = rounded_down(across) / static_cast<double>(sine);
    }
    const double w = number(waves[i], "w"), amplitude = number(waves[i], "A");
    const long double at_anchor = std::fmod(static_cast<long double>(w) * r * std::atan2(sine, cosine), whole_turn) +
                                  std::fmod(static_cast<long double>(number(waves[i], "phi")) * t, whole_turn);
    add(numbers, outward);
    add(numbers, glm::cross(rounded_down(a), outward));
    numbers.insert(numbers.end(),
                   {static_cast<double>(cosine), static_cast<double>(sine), amplitude / r, w * r,
                    static_cast<double>(std::remainder(at_anchor, whole_turn)), number(waves[i], "Q") * amplitude / r});
  }
  return numbers;
}

Json random_sea(Random& random) {
  const double r = stretched(random, 1.0, 1e8);
  const double length = r * random.log_between(random.chance(0.2) ? 1e-10 : 1e-6, 0.1);
  const double reach = length * random.log_between(1e-3, 1e3);
  const glm::dvec3 anchor = random.on_sphere();
  const glm::dvec3 side = glm::normalize(glm::cross(anchor, random.on_sphere()));
  const std::size_t counts[] = {0, 1, 1, 2, 8, 8, 20};
  const std::size_t count = counts[random.below(7)];
  const double steepness = random.between(0.0, 1.2);
  Json waves = Json::array();
  for (std::size_t i = 0; i < count; ++i) {
    glm::dvec3 o = random.on_sphere();
    // Near the anchor or opposite to it, though not within a few lengths.
    if (random.chance(0.2)) {
      const double arc = std::fmin(1.0, length / r * random.log_between(20.0, 1e4) + 2.0 * reach / r);
      o = (random.chance(0.5) ? 1.0 : -1.0) * (std::cos(arc) * anchor + std::sin(arc) * side);
    }
    const double w = turn / (length * random.between(0.5, 1.5));
    const double amplitude = random.chance(0.1) ? 0.0 : 1.0 / (w * static_cast<double>(count));
    waves.push_back({{"o", list(o)}, {"A", amplitude}, {"w", w}, {"phi", random.between(-3.0, 3.0)}, {"Q", steepness}});
  }
  Json args = {{"q", rounded(reach * glm::normalize(random.on_sphere() + 0.01 * side))},
               {"anchor", list(r * anchor)},
               {"r", r},
               {"t", random.chance(0.1) ? 1e9 : random.between(-1e5, 1e5)},
               {"waves", waves}};
  if (random.chance(0.5)) args["fade"] = Json::array({0.01, random.between(0.02, 1.0)});
  return args;
}

Numbers allowed_gerstner(const Case& c) {
  const glm::dvec3 q(c.numbers[0], c.numbers[1], c.numbers[2]), a(c.numbers[3], c.numbers[4], c.numbers[5]);
  const double r = c.numbers[6], arc = glm::length(q) / r;
  double shift = 16.0 * u * r * 1e-7, slope = 1.75e-4, stretch = 16.0 * u;  // 0.01 degrees
  for (std::size_t at = 10; at < c.numbers.size(); at += 12) {
    const glm::dvec3 outward(c.numbers[at], c.numbers[at + 1], c.numbers[at + 2]);
    const double sine = c.numbers[at + 7], cosine = c.numbers[at + 6];
    const glm::dvec3 side(c.numbers[at + 3], c.numbers[at + 4], c.numbers[at + 5]);
    const double across =
        std::hypot((1.0 + glm::dot(q, a) / r) * sine + glm::dot(q, outward) / r * cosine, glm::dot(q, side) / r);
    const double w = c.numbers[at + 9], amplitude = std::fabs(c.numbers[at + 8]), pinch = std::fabs(c.numbers[at + 11]);
    const double phase = (c.gpu ? 2.5e-4 : 1e-5) + 16.0 * u * w * arc;
    const double direction = 16.0 * u * (1.0 + (sine + arc) / across);
    shift += r * ((amplitude + pinch) * phase + pinch * direction);
    slope += w * (amplitude + pinch) * (16.0 * u * w * arc + direction);
    stretch += (w + 1.0 / across) * (amplitude + pinch) * (phase + direction);
  }
  // Where the surface folds its normal turns over within no distance.
  const double normal = c.answers[6] > 0.1 ? (c.gpu ? 5.0 : 1.0) * slope / std::fmin(1.0, c.answers[6]) : 2.0;
  return {shift, shift, shift, normal, normal, normal, 2.0 * stretch};
}

Function gerstner() {
  Function f;
  f.name = "gerstner";
  f.args = {squared({"q", Kind::triple, "m"}),
            of_host({"anchor", Kind::triple, "m"}),
            of_host(squared({"r", Kind::number, "m", positive})),
            of_host({"t", Kind::number, "s"}),
            of_host({"waves",
                     Kind::objects,
                     "",
                     any,
                     false,
                     {},
                     {{"o", Kind::triple},
                      {"A", Kind::number, "m"},
                      {"w", Kind::number, "rad/m"},
                      {"phi", Kind::number, "rad/s"},
                      {"Q"}}}),
            {"fade", Kind::pair, "", any, true}};
  f.outputs = {{"disp", 0, 3}, {"normal", 3, 3}, {"jac", 6}};
  f.prepare = prepare_gerstner;
  f.random = random_sea;
  f.allowed = allowed_gerstner;
  return f;
}

}  // namespace

std::vector<Function> wave_functions() { return {gerstner()}; }

}  // namespace terrella::probe
