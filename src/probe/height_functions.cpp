// Heights. Definitions and bounds of errors: docs/numerics.md.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/text.hpp"
#include "formulas/formulas.hpp"
#include "probe/table.hpp"

namespace terrella::probe {
namespace {

Function octave_sum() {
  Function f;
  f.name = "octave_sum";
  f.args = {{"values", Kind::numbers},
            {"persistence"},
            {"mode", Kind::word, "", any, false, {"fbm", "ridge"}},
            {"k", Kind::number, "", not_negative, true}};
  f.outputs = {{"h", 0}};
  f.prepare = [](const Json& args) -> Prepared {
    Numbers numbers = {number(args, "persistence"), args["mode"] == "ridge" ? 1.0 : 0.0, number_or(args, "k", 1e30),
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

}  // namespace

std::vector<Function> height_functions() { return {octave_sum(), smooth_abs(), height_power()}; }

}  // namespace terrella::probe
