#include "probe/formula.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <glm/geometric.hpp>

#include "base/check.hpp"
#include "probe/arguments.hpp"
#include "probe/evaluate.hpp"

namespace terrella::probe {
namespace {

[[noreturn]] void no_formula_takes(const Arg& arg) { fail_check(__FILE__, __LINE__, "kind", std::string(arg.name)); }

void flatten(Numbers& numbers, const Json& value, const Arg& arg) {
  switch (arg.kind) {
    case Kind::number: numbers.push_back(value.get<double>()); break;
    case Kind::whole:
      if (arg.of_host) {
        add_bits(numbers, static_cast<unsigned>(value.get<double>()));
      } else {
        numbers.push_back(value.get<double>());
      }
      break;
    case Kind::spread: add(numbers, triple(value)); break;
    case Kind::triple: add(numbers, triple(value)); break;
    case Kind::word: {
      const auto found = std::find(arg.words.begin(), arg.words.end(), value.get<std::string>());
      numbers.push_back(static_cast<double>(found - arg.words.begin()));
      break;
    }
    case Kind::object:
      for (const Arg& field : arg.fields) flatten(numbers, value[field.name], field);
      break;
    case Kind::objects:
      numbers.push_back(static_cast<double>(value.size()));
      for (const Json& one : value) {
        for (const Arg& field : arg.fields) flatten(numbers, one[field.name], field);
      }
      break;
    case Kind::pair:
    case Kind::numbers: no_formula_takes(arg);
  }
}

// Adds to sizes, of which there is one for each number so far, what the rounding of an argument's numbers is relative
// to; 0 where they are exact.
void add_sizes(Numbers& sizes, std::span<const double> numbers, const Arg& arg) {
  const std::size_t at = sizes.size();
  switch (arg.kind) {
    case Kind::number: sizes.push_back(std::fabs(numbers[at])); break;
    case Kind::whole: sizes.resize(at + (arg.of_host ? 2 : 1)); break;
    case Kind::word: sizes.push_back(0.0); break;
    case Kind::triple: sizes.resize(at + 3, std::hypot(numbers[at], numbers[at + 1], numbers[at + 2])); break;
    case Kind::spread:
      for (std::size_t i = at; i < at + 3; ++i) sizes.push_back(std::fabs(numbers[i]));
      break;
    case Kind::object:
      for (const Arg& field : arg.fields) add_sizes(sizes, numbers, field);
      break;
    case Kind::objects:
      sizes.push_back(0.0);
      for (auto left = static_cast<int>(numbers[at]); left > 0; --left) {
        for (const Arg& field : arg.fields) add_sizes(sizes, numbers, field);
      }
      break;
    case Kind::pair:
    case Kind::numbers: no_formula_takes(arg);
  }
}

// Of the answers that make up one member, or of a single one.
double size_of(const Output& output, std::span<const double> answers) {
  double square = 0.0;
  for (std::size_t i = 0; i < std::max<std::size_t>(output.count, 1); ++i) {
    square += answers[output.first + i] * answers[output.first + i];
  }
  return std::sqrt(square);
}

Numbers allowed_by_arguments(const Formula& formula, const Case& c) {
  const double part = (c.gpu ? formula.on_gpu : formula.on_cpu) * u;
  const double least = formula.made_from ? formula.made_from(c.numbers) : 0.0;
  Numbers allowed;
  for (const Output& output : formula.outputs) {
    const double own = part * (size_of(output, c.answers) + least) + faint;
    allowed.insert(allowed.end(), std::max<std::size_t>(output.count, 1), own);
  }
  Numbers sizes;
  for (const Arg& arg : formula.args) add_sizes(sizes, c.numbers, arg);
  Numbers numbers(c.numbers.begin(), c.numbers.end());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (sizes[i] == 0.0) continue;
    numbers[i] = c.numbers[i] - part * sizes[i];
    const Answers<double> before = evaluate_f64(formula.name, numbers, c.map);
    numbers[i] = c.numbers[i] + part * sizes[i];
    const Answers<double> after = evaluate_f64(formula.name, numbers, c.map);
    numbers[i] = c.numbers[i];
    for (std::size_t k = 0; k < allowed.size(); ++k) {
      allowed[k] += std::fmax(std::fabs(before[k] - c.answers[k]), std::fabs(after[k] - c.answers[k]));
    }
  }
  return allowed;
}

// A float's value next to x, within the range.
double rounded_within(double x, const Range& range) {
  const double near = rounded(x);
  if (near < range.low) return static_cast<double>(std::nextafter(static_cast<float>(near), HUGE_VALF));
  return near > range.high ? static_cast<double>(std::nextafter(static_cast<float>(near), -HUGE_VALF)) : near;
}

}  // namespace

Json made_up(const Arg& arg, Random& random) {
  const Range& range = arg.range;
  const auto within = [&] {
    if (random.chance(0.1)) return rounded_within(random.chance(0.5) ? range.low : range.high, range);
    const bool wide = range.low > 0.0 && range.high > 100.0 * range.low;
    const double x = wide ? random.log_between(range.low, range.high) : random.between(range.low, range.high);
    return rounded_within(x, range);
  };
  switch (arg.kind) {
    case Kind::number: return within();
    case Kind::whole: return static_cast<double>(random.below(static_cast<std::size_t>(range.high) + 1));
    case Kind::spread: return Json::array({within(), within(), within()});
    case Kind::word: return arg.words[random.below(arg.words.size())];
    case Kind::triple:
      return list(random.on_sphere() * (range.high == 1.0 ? 1.0 : range.high * random.log_between(1e-3, 1.0)));
    case Kind::object: {
      Json object = Json::object();
      for (const Arg& field : arg.fields) object[field.name] = made_up(field, random);
      return object;
    }
    case Kind::objects: {
      Json objects = Json::array();
      Arg one = arg;
      one.kind = Kind::object;
      for (std::size_t left = random.below(5); left > 0; --left) objects.push_back(made_up(one, random));
      return objects;
    }
    case Kind::pair:
    case Kind::numbers: break;
  }
  no_formula_takes(arg);
}

Function function_of(Formula formula) {
  const auto shared = std::make_shared<const Formula>(std::move(formula));
  Function f;
  f.name = shared->name;
  f.args = shared->args;
  f.outputs = shared->outputs;
  f.prepare = [shared](const Json& args) -> Prepared {
    Numbers numbers;
    for (const Arg& arg : shared->args) flatten(numbers, args[arg.name], arg);
    return numbers;
  };
  f.random = [shared](Random& random) {
    Json args = Json::object();
    for (const Arg& arg : shared->args) args[arg.name] = made_up(arg, random);
    if (shared->fit) shared->fit(args, random);
    return as_told(args, shared->args, Precision::gpu);
  };
  f.allowed = [shared](const Case& c) { return allowed_by_arguments(*shared, c); };
  f.rarity = shared->rarity;
  return f;
}

}  // namespace terrella::probe
