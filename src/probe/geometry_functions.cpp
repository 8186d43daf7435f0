// Grids, horizons, angles and rays. Definitions and bounds of errors: docs/numerics.md.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/text.hpp"
#include "formulas/formulas.hpp"
#include "probe/table.hpp"

namespace terrella::probe {
namespace {

Function grid_offset() {
  Function f;
  f.name = "grid_offset";
  f.args = {squared({"r", Kind::number, "m", positive}), squared({"alt", Kind::number, "m"}),
            squared({"h_max", Kind::number, "m", not_negative})};
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
constexpr Range within_grid{-1.0, 1.0};

std::string trouble_with_n(double n) {
  if (std::fmod(n, 2.0) == 0.0) return {};
  return text_of("n: ", n, " is odd; it is an even number, so that the grid is the same on both sides.");
}

Function grid_point() {
  Function f;
  f.name = "grid_point";
  f.args = {{"gx", Kind::number, "", within_grid},
            {"gy", Kind::number, "", within_grid},
            squared({"zs"}),
            {"n", Kind::whole, "", even_numbers}};
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
  f.args = {{"gx", Kind::number, "", within_grid},
            {"gy", Kind::number, "", within_grid},
            {"n", Kind::whole, "", even_numbers},
            of_host(squared({"r", Kind::number, "m", positive})),
            of_host({"h_max", Kind::number, "m", not_negative}),
            of_host(squared({"cam", Kind::triple, "m"})),
            of_host({"b", Kind::triple})};
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
  f.args = {squared({"r", Kind::number, "m", positive}), squared({"alt", Kind::number, "m", not_negative}),
            squared({"h_max", Kind::number, "m", not_negative})};
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

// How many times a vector's largest part has to be halved to lie between a half and 1.
int halvings(const glm::dvec3& v) {
  int exponent = 0;
  std::frexp(std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}), &exponent);
  return exponent;
}

glm::dvec3 halved(const glm::dvec3& v, int times) {
  return {std::ldexp(v.x, -times), std::ldexp(v.y, -times), std::ldexp(v.z, -times)};
}

Function arc_angle() {
  Function f;
  f.name = "arc_angle";
  f.args = {of_host({"a", Kind::triple}), of_host({"b", Kind::triple})};
  f.outputs = {{"angle", 0}};
  f.prepare = [](const Json& args) -> Prepared {
    for (const char* name : {"a", "b"}) {
      if (triple(args, name) == glm::dvec3(0.0)) {
        return Failure{text_of("arc_angle: ", name, " is 0 and so has no direction.")};
      }
    }
    // Angles know no unit: one in which b is about 1 long, so that no square is too small or too large for a float.
    // Halving loses no digit. What is not of about the same length as b is made so.
    glm::dvec3 a = triple(args, "a"), b = triple(args, "b");
    const int of_a = halvings(a), of_b = halvings(b);
    a = halved(a, std::abs(of_a - of_b) > 1 ? of_a : of_b);
    b = halved(b, of_b);
    Numbers numbers;
    add(numbers, a);
    add(numbers, b);
    return numbers;
  };
  f.random = [](Random& random) {
    const glm::dvec3 a = random.on_sphere();
    const glm::dvec3 side = glm::normalize(glm::cross(a, random.on_sphere()));
    double angle = random.chance(0.5) ? random.between(0.0, std::numbers::pi) : random.log_between(1e-7, 1.0);
    if (random.chance(0.2)) angle = std::numbers::pi - angle;
    const double size = random.chance(0.5) ? 1.0 : random.log_between(1e-30, 1e30);
    double other = size;
    if (random.chance(0.3)) other *= random.chance(0.8) ? random.between(0.51, 1.9) : random.log_between(1e-6, 1e6);
    return Json{{"a", rounded(size * a)}, {"b", rounded(other * (std::cos(angle) * a + std::sin(angle) * side))}};
  };
  f.allowed = [](const Case& c) {
    const double a = glm::length(glm::dvec3(c.numbers[0], c.numbers[1], c.numbers[2]));
    const double b = glm::length(glm::dvec3(c.numbers[3], c.numbers[4], c.numbers[5]));
    return Numbers{8.0 * u * (c.answers[0] + std::fabs(a - b) / b)};
  };
  return f;
}

Function ray_sphere() {
  Function f;
  f.name = "ray_sphere";
  f.args = {squared({"o", Kind::triple, "m"}), squared({"d", Kind::triple}),
            squared({"r", Kind::number, "m", positive})};
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
  f.args = {squared({"r", Kind::number, "m", positive}),
            squared({"alt", Kind::number, "m"}),
            {"mu", Kind::number, "", {-1.0, 1.0}},
            squared({"h", Kind::number, "m"})};
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

}  // namespace

std::vector<Function> geometry_functions() {
  return {grid_offset(), grid_point(), grid_world(), arc_angle(),
          ray_sphere(),  ray_shell(),  horizon(),    split_distance()};
}

}  // namespace terrella::probe
