#include "probe/table.hpp"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/text.hpp"
#include "formulas/formulas.hpp"

namespace terrella::probe {

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

void add_bits(Numbers& numbers, unsigned bits) {
  numbers.insert(numbers.end(), {static_cast<double>(bits >> 16U), static_cast<double>(bits & 0xffffU)});
}

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

double rounded(double x) { return static_cast<double>(static_cast<float>(x)); }

Json rounded(const glm::dvec3& v) { return Json::array({rounded(v.x), rounded(v.y), rounded(v.z)}); }

Json list(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

double stretched(Random& random, double low, double high) {
  if (random.chance(0.05)) return rounded(random.chance(0.5) ? low : high);
  return rounded(random.log_between(low, high));
}

double altitude(Random& random) { return random.chance(0.05) ? 0.0 : stretched(random, 1e-4, 1e9); }

std::function<Numbers(const Case&)> relative(double on_cpu, double on_gpu) {
  return [=](const Case& c) {
    Numbers allowed;
    for (const double answer : c.answers) allowed.push_back((c.gpu ? on_gpu : on_cpu) * u * std::fabs(answer) + faint);
    return allowed;
  };
}

std::function<Numbers(const Case&)> absolute(double on_cpu, double on_gpu) {
  return [=](const Case& c) { return Numbers(c.answers.size(), (c.gpu ? on_gpu : on_cpu) * u); };
}

double allowed_of_power(double x, double exponent, bool gpu) {
  const double logarithm = std::fabs(exponent * std::log2(std::fmin(std::fmax(x, 1e-45), 1.0)));
  const double bound = u * (8.0 + 4.0 * logarithm);
  return gpu ? 4.0 * bound + exponent * 0x1p-20 : bound;
}

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

}  // namespace terrella::probe
