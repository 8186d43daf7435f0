// The table of the probe's functions. Definitions and bounds of errors: docs/numerics.md.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/text.hpp"
#include "formulas/formulas.hpp"
#include "probe/function.hpp"

namespace terrella::probe {
namespace {

using Numbers = std::vector<double>;
using Prepared = Result<Numbers>;

constexpr double turn = 2.0 * std::numbers::pi;
constexpr double u = 0x1p-24;       // the most that rounding to single precision moves a number by, relative to it
constexpr double faint = 1.2e-38;   // single precision holds smaller numbers badly, and drivers not at all
constexpr double anything = 1e300;  // an error that is allowed where nothing can be decided

// --- What is read of arguments that are there and in range ---

double number(const Json& args, const char* name) { return args[name].get<double>(); }

bool has(const Json& args, const char* name) {
  const auto found = args.find(name);
  return found != args.end() && !found->is_null();
}

double number_or(const Json& args, const char* name, double otherwise) {
  return has(args, name) ? number(args, name) : otherwise;
}

glm::dvec3 triple(const Json& value) {
  if (value.is_number()) return glm::dvec3(value.get<double>());
  return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
}

glm::dvec3 triple(const Json& args, const char* name) { return triple(args[name]); }

void add(Numbers& numbers, const glm::dvec3& v) { numbers.insert(numbers.end(), {v.x, v.y, v.z}); }

// An unsigned integer as two halves of 16 bits, which a float holds.
void add_bits(Numbers& numbers, unsigned bits) {
  numbers.insert(numbers.end(), {static_cast<double>(bits >> 16U), static_cast<double>(bits & 0xffffU)});
}

// The numbers of the arguments as they come.
std::function<Prepared(const Json&)> as_they_come(std::vector<const char*> names) {
  return [names = std::move(names)](const Json& args) -> Prepared {
    Numbers numbers;
    for (const char* name : names) {
      if (args[name].is_array()) {
        for (const Json& one : args[name]) numbers.push_back(one.get<double>());
      } else {
        numbers.push_back(number(args, name));
      }
    }
    return numbers;
  };
}

// --- For --fuzz ---

double rounded(double x) { return static_cast<double>(static_cast<float>(x)); }

Json rounded(const glm::dvec3& v) { return Json::array({rounded(v.x), rounded(v.y), rounded(v.z)}); }

Json list(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

// Mostly spread over its orders of magnitude, now and then one of the ends.
double stretched(Random& random, double low, double high) {
  if (random.chance(0.05)) return rounded(random.chance(0.5) ? low : high);
  return rounded(random.log_between(low, high));
}

double altitude(Random& random) { return random.chance(0.05) ? 0.0 : stretched(random, 1e-4, 1e9); }

// An error of so many u of each answer.
std::function<Numbers(const Case&)> relative(double on_cpu, double on_gpu) {
  return [=](const Case& c) {
    Numbers allowed;
    for (const double answer : c.answers) allowed.push_back((c.gpu ? on_gpu : on_cpu) * u * std::fabs(answer) + faint);
    return allowed;
  };
}

// An error of so many u, whatever the answer.
std::function<Numbers(const Case&)> absolute(double on_cpu, double on_gpu) {
  return [=](const Case& c) { return Numbers(c.answers.size(), (c.gpu ? on_gpu : on_cpu) * u); };
}

// --- Grids and horizons (Michelic 2018) ---

Function grid_offset() {
  Function f;
  f.name = "grid_offset";
  f.args = {{"r", Kind::number, "m", positive}, {"alt", Kind::number, "m"}, {"h_max", Kind::number, "m", not_negative}};
  f.outputs = {{"h", 0}, {"s", 1}, {"zs", 2}, {"phi", 3}};
  f.prepare = [](const Json& args) -> Prepared {
    const Numbers numbers = {number(args, "r"), number(args, "alt"), number(args, "h_max")};
    if (numbers[1] <= 0.0 && numbers[2] == 0.0) {
      return Failure{"grid_offset: alt and h_max are both 0, so there is no horizon to reach; give one above 0."};
    }
    return numbers;
  };
  f.random = [](Random& random) {
    const double r = stretched(random, 1.0, 1e8);
    double alt = altitude(random);
    if (random.chance(0.05)) alt = rounded(-random.between(0.0, 1.2) * r);
    const double h_max = random.chance(0.2) && alt > 0.0 ? 0.0 : rounded(r * random.log_between(1e-9, 2.0));
    return Json{{"r", r}, {"alt", alt}, {"h_max", h_max}};
  };
  f.allowed = [](const Case& c) {
    const double r = c.numbers[0], h = c.answers[0], s = c.answers[1];
    const double cotangent = (r * r + h * s) / (r * (h + s));
    return Numbers{8.0 * u * h, 8.0 * u * s, 8.0 * u * cotangent, 8.0 * u * c.answers[3]};
  };
  return f;
}

constexpr Range even_numbers{2.0, 0x1p30};

std::string trouble_with_n(double n) {
  if (std::fmod(n, 2.0) == 0.0) return {};
  return text_of("n: ", n, " is odd; it is an even number, so that the grid is the same on both sides.");
}

Function grid_point() {
  Function f;
  f.name = "grid_point";
  f.args = {{"gx"}, {"gy"}, {"zs"}, {"n", Kind::whole, "", even_numbers}};
  f.outputs = {{"gz", 0}, {"dir", 1, 3}};
  f.prepare = [](const Json& args) -> Prepared {
    if (std::string trouble = trouble_with_n(number(args, "n")); !trouble.empty()) return Failure{trouble};
    return as_they_come({"gx", "gy", "zs", "n"})(args);
  };
  f.random = [](Random& random) {
    const auto place = [&] {
      const double edge = random.log_between(1e-8, 1.0);
      return rounded((random.chance(0.5) ? -1.0 : 1.0) * (random.chance(0.3) ? 1.0 - edge : edge));
    };
    const double zs = random.chance(0.5) ? random.between(-0.95, 1.0) : random.log_between(1e-4, 1e4);
    const double n = 2.0 * static_cast<double>(1 + random.below(random.chance(0.8) ? 8 : 500));
    return Json{{"gx", place()}, {"gy", place()}, {"zs", rounded(zs)}, {"n", n}};
  };
  f.allowed = [](const Case& c) {
    const double rise = c.answers[0];
    const double sum = rise + std::fabs(c.numbers[2]);
    const double size = std::sqrt(c.numbers[0] * c.numbers[0] + c.numbers[1] * c.numbers[1] +
                                  (rise + c.numbers[2]) * (rise + c.numbers[2]));
    const double bound = (c.numbers[3] + 6.0) * u, of_direction = bound * std::fmax(1.0, sum / size);
    return Numbers{bound, of_direction, of_direction, of_direction};
  };
  return f;
}

Function grid_world() {
  Function f;
  f.name = "grid_world";
  f.args = {{"gx"},
            {"gy"},
            {"n", Kind::whole, "", even_numbers},
            {"r", Kind::number, "m", positive},
            {"h_max", Kind::number, "m", not_negative},
            {"cam", Kind::triple, "m"},
            {"b", Kind::triple}};
  f.outputs = {{"rel", 0, 3}};
  f.prepare = [](const Json& args) -> Prepared {
    if (std::string trouble = trouble_with_n(number(args, "n")); !trouble.empty()) return Failure{trouble};
    const glm::dvec3 cam = triple(args, "cam"), b = triple(args, "b");
    const double away = glm::length(cam), r = number(args, "r"), h_max = number(args, "h_max");
    if (!(away > 0.0)) return Failure{"grid_world: cam lies at the planet's centre, so that no direction is up."};
    const glm::dvec3 w = cam / away;
    if (!(glm::length(glm::cross(w, b)) > 1e-15 * glm::length(b))) {
      return Failure{"grid_world: b is parallel to cam or 0, so that the grid has no second axis; give another b."};
    }
    if (!(away > r) && h_max == 0.0) {
      return Failure{"grid_world: cam is not above r and h_max is 0, so there is no horizon to reach."};
    }
    const double alt = away - r;
    glm::dvec3 east, north;
    f64::camera_axes(w, b, east, north);
    Numbers numbers = {
        number(args, "gx"), number(args, "gy"), number(args, "n"), f64::grid_offset(r, alt, h_max).zs, r, alt};
    add(numbers, east);
    add(numbers, north);
    add(numbers, w);
    return numbers;
  };
  f.random = [](Random& random) {
    const double r = stretched(random, 1.0, 1e8);
    const double h_max = r * random.log_between(1e-9, 0.4);
    const glm::dvec3 up = random.chance(0.1) ? glm::normalize(glm::dvec3(1e-8, 0.0, 1.0)) : random.on_sphere();
    const glm::dvec3 b = random.chance(0.5) ? glm::dvec3(0.0, 0.0, 1.0) : 10.0 * random.on_sphere();
    const auto place = [&] { return rounded((random.chance(0.5) ? -1.0 : 1.0) * random.log_between(1e-8, 1.0)); };
    return Json{{"gx", place()}, {"gy", place()},  {"n", 2.0 * static_cast<double>(1 + random.below(4))},
                {"r", r},        {"h_max", h_max}, {"cam", list(up * (r + altitude(random)))},
                {"b", list(b)}};
  };
  f.allowed = [](const Case& c) {
    const double size = glm::length(glm::dvec3(c.answers[0], c.answers[1], c.answers[2]));
    return Numbers(3, (c.gpu ? 32.0 : 16.0) * u * size);
  };
  return f;
}

Function horizon() {
  Function f;
  f.name = "horizon";
  f.args = {{"r", Kind::number, "m", positive},
            {"alt", Kind::number, "m", not_negative},
            {"h_max", Kind::number, "m", not_negative}};
  f.outputs = {{"dist", 0}, {"angle", 1}, {"cull_angle", 2}};
  f.prepare = as_they_come({"r", "alt", "h_max"});
  f.random = [](Random& random) {
    const double r = stretched(random, 1.0, 1e8);
    const double h_max = random.chance(0.1) ? 0.0 : rounded(r * random.log_between(1e-9, 2.0));
    return Json{{"r", r}, {"alt", altitude(random)}, {"h_max", h_max}};
  };
  f.allowed = relative(8.0, 8.0);
  return f;
}

Function split_distance() {
  Function f;
  f.name = "split_distance";
  f.args = {{"edge", Kind::number, "m", not_negative},
            {"max_px", Kind::number, "px", positive},
            {"fov_x", Kind::number, "rad", {0.0, std::numbers::pi, true}},
            {"width", Kind::number, "px", positive}};
  f.outputs = {{"dist", 0}};
  f.prepare = as_they_come({"edge", "max_px", "fov_x", "width"});
  f.random = [](Random& random) {
    const double degree = std::numbers::pi / 180.0;
    return Json{{"edge", stretched(random, 1e-3, 1e8)},
                {"max_px", stretched(random, 0.5, 100.0)},
                {"fov_x", rounded(random.between(1.0 * degree, 175.0 * degree))},
                {"width", rounded(std::floor(random.log_between(1.0, 16384.0)))}};
  };
  f.allowed = [](const Case& c) {
    const double condition = c.numbers[2] / std::sin(c.numbers[2]);
    return Numbers{u * (4.0 + 4.0 * condition) * c.answers[0]};
  };
  return f;
}

Function arc_angle() {
  Function f;
  f.name = "arc_angle";
  f.args = {{"a", Kind::triple}, {"b", Kind::triple}};
  f.outputs = {{"angle", 0}};
  f.prepare = [](const Json& args) -> Prepared {
    for (const char* name : {"a", "b"}) {
      if (triple(args, name) == glm::dvec3(0.0)) {
        return Failure{text_of("arc_angle: ", name, " is 0 and so has no direction.")};
      }
    }
    return as_they_come({"a", "b"})(args);
  };
  f.random = [](Random& random) {
    const glm::dvec3 a = random.on_sphere();
    const glm::dvec3 side = glm::normalize(glm::cross(a, random.on_sphere()));
    double angle = random.chance(0.5) ? random.between(0.0, std::numbers::pi) : random.log_between(1e-7, 1.0);
    if (random.chance(0.2)) angle = std::numbers::pi - angle;
    const double size = random.chance(0.5) ? 1.0 : random.log_between(1e-6, 1e8);
    const double other = random.chance(0.7) ? size : size * random.between(0.51, 1.9);
    return Json{{"a", rounded(size * a)}, {"b", rounded(other * (std::cos(angle) * a + std::sin(angle) * side))}};
  };
  f.allowed = [](const Case& c) {
    const double a = glm::length(glm::dvec3(c.numbers[0], c.numbers[1], c.numbers[2]));
    const double b = glm::length(glm::dvec3(c.numbers[3], c.numbers[4], c.numbers[5]));
    return Numbers{8.0 * u * (c.answers[0] + std::fabs(a - b) / b)};
  };
  return f;
}

// --- Rays ---

Function ray_sphere() {
  Function f;
  f.name = "ray_sphere";
  f.args = {{"o", Kind::triple, "m"}, {"d", Kind::triple}, {"r", Kind::number, "m", positive}};
  f.prepare = [](const Json& args) -> Prepared {
    if (triple(args, "d") == glm::dvec3(0.0)) return Failure{"ray_sphere: d is 0 and so has no direction."};
    return as_they_come({"o", "d", "r"})(args);
  };
  f.shape = [](const Json&, std::span<const double> answers) {
    return std::vector<Output>{{"t", 1, 2, answers[0] == 0.0}};
  };
  f.random = [](Random& random) {
    const double r = stretched(random, 1.0, 1e8);
    const double away = r * (random.chance(0.5) ? random.between(0.0, 2.0) : random.log_between(1.0, 1e3));
    const glm::dvec3 o = away * random.on_sphere();
    const glm::dvec3 toward =
        random.chance(0.5) ? random.on_sphere() : glm::normalize(1.2 * r * random.on_sphere() - o);
    return Json{{"o", rounded(o)}, {"d", rounded(random.log_between(1e-3, 1e3) * toward)}, {"r", r}};
  };
  f.allowed = [](const Case& c) {
    const glm::dvec3 o(c.numbers[0], c.numbers[1], c.numbers[2]), d(c.numbers[3], c.numbers[4], c.numbers[5]);
    const double r = c.numbers[6], scale = glm::length(o) + r, size = glm::length(d);
    const double nearest = glm::length(glm::cross(o, d)) / size;
    // The nearest place of the ray is known to u of the eye's distance. Near grazing that decides on whether it meets.
    const double known = 16.0 * u * scale * scale, square = (r - nearest) * (r + nearest);
    if (std::fabs(square) <= known) return Numbers(3, anything);
    if (square < 0.0) return Numbers(3, 0.0);
    const double root = 16.0 * u * scale * (1.0 + scale / std::sqrt(square)) / size;
    return Numbers{0.0, root, root};
  };
  return f;
}

Function ray_shell() {
  Function f;
  f.name = "ray_shell";
  f.args = {{"r", Kind::number, "m", positive},
            {"alt", Kind::number, "m"},
            {"mu", Kind::number, "", {-1.0, 1.0}},
            {"h", Kind::number, "m"}};
  f.prepare = as_they_come({"r", "alt", "mu", "h"});
  f.shape = [](const Json&, std::span<const double> answers) {
    const bool none = answers[0] == 0.0;
    return std::vector<Output>{{"t0", 1, 0, none}, {"t1", 2, 0, none}};
  };
  f.random = [](Random& random) {
    const double r = stretched(random, 1.0, 1e8), alt = altitude(random);
    double h =
        random.chance(0.5) ? rounded(r * random.log_between(1e-9, 1.0)) : rounded(alt * random.between(0.5, 1.5));
    if (random.chance(0.1)) h = 0.0;
    double mu = random.between(-1.0, 1.0);
    // From far away, towards the shell.
    if (random.chance(0.5))
      mu = -std::sqrt(std::fmax(0.0, 1.0 - std::pow(random.between(0.0, 1.1) * (r + h) / (r + alt), 2)));
    if (random.chance(0.05)) mu = random.chance(0.5) ? 1.0 : -1.0;
    return Json{{"r", r}, {"alt", alt}, {"mu", rounded(mu)}, {"h", h}};
  };
  f.allowed = [](const Case& c) {
    const double r = c.numbers[0], alt = c.numbers[1], mu = c.numbers[2], h = c.numbers[3];
    const double away = r + alt, along = away * mu;
    const double quarter = (r + h) * (r + h) - away * away * (1.0 - mu) * (1.0 + mu);
    // What the discriminant is the difference of, as it is computed.
    const double shell = (r + h) * (r + h), gap = std::fabs(alt - h) * (2.0 * r + alt + h);
    const double parts = std::fabs(mu) > 0.7 ? 2.0 * shell : along * along + gap;
    if (std::fabs(quarter) <= 16.0 * u * parts) return Numbers(3, anything);
    if (quarter < 0.0) return Numbers(3, 0.0);
    const double chord = std::sqrt(quarter), far = std::fabs(along) + chord;
    const double bound = 16.0 * u * (1.0 + parts / (chord * far));
    return Numbers{0.0, bound * std::fabs(c.answers[1]) + faint, bound * std::fabs(c.answers[2]) + faint};
  };
  return f;
}

// --- Waves ---

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
  f.args = {{"q", Kind::triple, "m"},
            {"anchor", Kind::triple, "m"},
            {"r", Kind::number, "m", positive},
            {"t", Kind::number, "s"},
            {"waves",
             Kind::objects,
             "",
             any,
             false,
             {},
             {{"o", Kind::triple},
              {"A", Kind::number, "m"},
              {"w", Kind::number, "rad/m"},
              {"phi", Kind::number, "rad/s"},
              {"Q"}}},
            {"fade", Kind::pair, "", any, true}};
  f.outputs = {{"disp", 0, 3}, {"normal", 3, 3}, {"jac", 6}};
  f.prepare = prepare_gerstner;
  f.random = random_sea;
  f.allowed = allowed_gerstner;
  return f;
}

// --- Heights (Sandahl 2022) ---

Function octave_sum() {
  Function f;
  f.name = "octave_sum";
  f.args = {{"values", Kind::numbers},
            {"persistence"},
            {"mode", Kind::word, "", any, false, {"fbm", "ridge"}},
            {"k", Kind::number, "", not_negative, true}};
  f.outputs = {{"h", 0}};
  f.prepare = [](const Json& args) -> Prepared {
    Numbers numbers = {number(args, "persistence"), args["mode"] == "ridge" ? 1.0 : 0.0, number_or(args, "k", -1.0),
                       static_cast<double>(args["values"].size())};
    for (const Json& value : args["values"]) numbers.push_back(value.get<double>());
    return numbers;
  };
  f.random = [](Random& random) {
    Json args = {{"values", Json::array()},
                 {"persistence", random.chance(0.1) ? 0.0 : rounded(random.between(0.0, 1.5))},
                 {"mode", random.chance(0.5) ? "fbm" : "ridge"}};
    const std::size_t count = random.below(25);
    for (std::size_t i = 0; i < count; ++i) args["values"].push_back(rounded(random.between(-1.01, 1.01)));
    if (random.chance(0.5)) args["k"] = rounded(random.log_between(1e-2, 1e3));
    return args;
  };
  f.allowed = [](const Case& c) {
    double most = 1.0;
    for (std::size_t i = 4; i < c.numbers.size(); ++i) most = std::fmax(most, std::fabs(c.numbers[i]));
    return Numbers{(12.0 + c.numbers[3]) * u * most};
  };
  return f;
}

Function smooth_abs() {
  Function f;
  f.name = "smooth_abs";
  f.args = {{"x"}, {"k"}};
  f.outputs = {{"y", 0}};
  f.prepare = as_they_come({"x", "k"});
  f.random = [](Random& random) {
    const double x = random.chance(0.5) ? random.between(-2.0, 2.0) : random.log_between(1e-9, 1e6);
    return Json{{"x", rounded(x)}, {"k", random.chance(0.05) ? 0.0 : stretched(random, 1e-3, 1e6)}};
  };
  f.allowed = [](const Case& c) { return Numbers{8.0 * u * std::fabs(c.numbers[0]) + faint}; };
  return f;
}

// The error of a power: it grows with the exponent and with the logarithm. Drivers compute it by way of both.
double allowed_of_power(double x, double exponent, bool gpu) {
  const double logarithm = std::fabs(exponent * std::log2(std::fmin(std::fmax(x, 1e-45), 1.0)));
  const double bound = u * (8.0 + 4.0 * logarithm);
  return gpu ? 4.0 * bound + exponent * 0x1p-20 : bound;
}

Function height_power() {
  Function f;
  f.name = "height_power";
  f.args = {{"h"}, {"H", Kind::number, "m"}, {"p", Kind::number, "", not_negative}};
  f.outputs = {{"y", 0}};
  f.prepare = as_they_come({"h", "H", "p"});
  f.random = [](Random& random) {
    const double ends[] = {0.0, 1.0, -1e-7, 1.0 + 1.2e-7, -1.0, 2.0};
    const double h = random.chance(0.2) ? ends[random.below(6)] : random.between(0.0, 1.0);
    return Json{{"h", rounded(h)},
                {"H", random.chance(0.05) ? 0.0 : stretched(random, 1e-3, 1e7)},
                {"p", random.chance(0.1) ? 0.0 : rounded(random.log_between(1e-3, 1e3))}};
  };
  f.allowed = [](const Case& c) {
    return Numbers{allowed_of_power(c.numbers[0], c.numbers[2], c.gpu) * c.answers[0] + faint * c.numbers[1] + faint};
  };
  return f;
}

// --- Light at surfaces ---

Function schlick() {
  Function f;
  f.name = "schlick";
  f.args = {{"cos"}, {"n1"}, {"n2"}};
  f.outputs = {{"R", 0}};
  f.prepare = [](const Json& args) -> Prepared {
    if (number(args, "n1") + number(args, "n2") == 0.0) return Failure{"schlick: n1 and n2 sum to 0."};
    return as_they_come({"cos", "n1", "n2"})(args);
  };
  f.random = [](Random& random) {
    const double c = random.chance(0.2) ? 1.0 - random.log_between(1e-7, 1.0) : random.between(-0.1, 1.0 + 2.4e-7);
    const double n1 = random.between(1.0, 4.0);
    return Json{{"cos", rounded(c)}, {"n1", rounded(n1)}, {"n2", rounded(random.between(1.0, 4.0))}};
  };
  // Compilers of drivers may leave out what only rounding makes unlike 0: then 1 - cos is raised as it was rounded.
  f.allowed = relative(8.0, 12.0);
  return f;
}

Function fresnel_alpha() {
  Function f;
  f.name = "fresnel_alpha";
  f.args = {{"cos"}, {"a", Kind::number, "", not_negative}};
  f.outputs = {{"alpha", 0}};
  f.prepare = as_they_come({"cos", "a"});
  f.random = [](Random& random) {
    const double c = random.chance(0.2) ? 1.0 - random.log_between(1e-7, 1.0) : random.between(-0.1, 1.0 + 2.4e-7);
    return Json{{"cos", rounded(c)}, {"a", random.chance(0.1) ? 0.0 : rounded(random.log_between(1e-3, 1e2))}};
  };
  f.allowed = [](const Case& c) {
    const double x = 1.0 - std::fmin(std::fmax(c.numbers[0], 0.0), 1.0);
    return Numbers{allowed_of_power(x, c.numbers[1], c.gpu) * c.answers[0] + faint};
  };
  return f;
}

Function wrap_diffuse() {
  Function f;
  f.name = "wrap_diffuse";
  f.args = {{"cos"}, {"w"}};
  f.outputs = {{"I", 0}};
  f.prepare = as_they_come({"cos", "w"});
  f.random = [](Random& random) {
    return Json{{"cos", rounded(random.between(-1.0, 1.0))},
                {"w", random.chance(0.1) ? static_cast<double>(random.below(2)) : rounded(random.between(0.0, 1.0))}};
  };
  f.allowed = absolute(4.0, 4.0);
  return f;
}

// --- Light in air and clouds ---

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
    const double depth = random.chance(0.05) ? 0.0 : random.log_between(1e-12, 700.0),
                 dist = random.log_between(1e-3, 1e6);
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
  return arg;
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

// --- Noise ---

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
            {"p", Kind::triple, "cells", any, true},
            {"cam", Kind::triple, "cells", any, true},
            {"q", Kind::triple, "cells", any, true},
            {"alpha", Kind::number, "rad", any, true},
            {"seed", Kind::whole, "", seeds, true},
            {"octaves", Kind::whole, "", count, true},
            {"lacunarity", Kind::number, "", lacunarities, true},
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

double Random::between(double low, double high) {
  return low + (high - low) * static_cast<double>(random_()) / 4294967295.0;
}

double Random::log_between(double low, double high) { return low * std::pow(high / low, between(0.0, 1.0)); }

std::size_t Random::below(std::size_t count) { return random_() % count; }

glm::dvec3 Random::on_sphere() {
  const double z = between(-1.0, 1.0), angle = between(0.0, turn);
  const double level = std::sqrt(std::fmax(0.0, 1.0 - z * z));
  return {level * std::cos(angle), level * std::sin(angle), z};
}

std::span<const Function> functions() {
  static const std::vector<Function> all = {
      grid_offset(),    grid_point(),    grid_world(),     gerstner(),   arc_angle(),    ray_sphere(),
      ray_shell(),      horizon(),       split_distance(), octave_sum(), smooth_abs(),   height_power(),
      schlick(),        fresnel_alpha(), wrap_diffuse(),   phase(),      beer_lambert(), transmittance(),
      single_scatter(), cloud_signal(),  cloud_march(),    march(),      noise()};
  return all;
}

const Function* find_function(std::string_view name) {
  for (const Function& function : functions()) {
    if (function.name == name) return &function;
  }
  return nullptr;
}

}  // namespace terrella::probe
