// Light at surfaces. Definitions and bounds of errors: docs/numerics.md.
#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "base/text.hpp"
#include "formulas/formulas.hpp"
#include "probe/table.hpp"

namespace terrella::probe {
namespace {

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
  // Beyond, what the rounding of 1 - cos has lost is no longer small when it is raised.
  constexpr Range powers{0.0, 1e4};
  f.args = {{"cos"}, {"a", Kind::number, "", powers}};
  f.outputs = {{"alpha", 0}};
  f.prepare = as_they_come({"cos", "a"});
  f.random = [](Random& random) {
    const double c = random.chance(0.2) ? 1.0 - random.log_between(1e-7, 1.0) : random.between(-0.1, 1.0 + 2.4e-7);
    return Json{{"cos", rounded(c)}, {"a", random.chance(0.1) ? 0.0 : rounded(random.log_between(1e-3, 1e4))}};
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
  f.args = {{"cos"}, {"w", Kind::number, "", {-1.0, std::numeric_limits<double>::infinity(), true}}};
  f.outputs = {{"I", 0}};
  f.prepare = as_they_come({"cos", "w"});
  f.random = [](Random& random) {
    return Json{{"cos", rounded(random.between(-1.0, 1.0))},
                {"w", random.chance(0.1) ? static_cast<double>(random.below(2)) : rounded(random.between(0.0, 1.0))}};
  };
  f.allowed = absolute(4.0, 4.0);
  return f;
}

}  // namespace

std::vector<Function> surface_functions() { return {schlick(), fresnel_alpha(), wrap_diffuse()}; }

}  // namespace terrella::probe
