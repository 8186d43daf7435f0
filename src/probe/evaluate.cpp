#include "probe/evaluate.hpp"

#include "base/check.hpp"
#include "formulas/formulas.hpp"

// One body, for as many numbers as it was given.
#define BODIES                                                                  \
  struct Bodies {                                                               \
    const Real* numbers;                                                        \
    Real* answers;                                                              \
    sampler2D height_map;                                                       \
    Real num(int i) const { return numbers[i]; }                                \
    vec3 triple(int i) const { return vec3(num(i), num(i + 1), num(i + 2)); }   \
    uint bits(int i) const { return uint(num(i)) * 65536U + uint(num(i + 1)); } \
    void put(int i, Real x) const { answers[i] = x; }                           \
    void put3(int i, const vec3& v) const { put(i, v.x), put(i + 1, v.y), put(i + 2, v.z); }

#define READER(type, name, ...) \
  type name(int i) const { __VA_ARGS__ }

#define BODY(name, ...) \
  void run_##name() const { __VA_ARGS__ }

namespace terrella::f32 {
namespace {
BODIES
#include "probe/bodies.inc"
#include "probe/readers.inc"
};
}  // namespace
}  // namespace terrella::f32

namespace terrella::f64 {
namespace {
BODIES
#include "probe/bodies.inc"
#include "probe/readers.inc"
};
}  // namespace
}  // namespace terrella::f64

#undef BODY
#undef READER

namespace terrella::probe {
namespace {

struct Compiled {
  std::string_view name;
  void (f32::Bodies::*single)() const;
  void (f64::Bodies::*twice)() const;
  std::string_view text;
};

#define BODY(name, ...) {#name, &f32::Bodies::run_##name, &f64::Bodies::run_##name, #__VA_ARGS__},
constexpr Compiled all[] = {
#include "probe/bodies.inc"
};
#undef BODY

#define READER(type, name, ...) #type " " #name "(int i) { " #__VA_ARGS__ " }\n"
constexpr std::string_view readers =
#include "probe/readers.inc"
    ;
#undef READER

const Compiled& find(std::string_view name) {
  for (const Compiled& one : all) {
    if (one.name == name) return one;
  }
  fail_check(__FILE__, __LINE__, "a body for each function", std::string(name));
}

HeightTexels texels_of(const HeightMap* map) {
  return map == nullptr ? HeightTexels{} : HeightTexels{map, map->serial()};
}

}  // namespace

Answers<float> evaluate_f32(std::string_view function, std::span<const float> numbers, const HeightMap* map) {
  Answers<float> answers{};
  (f32::Bodies{numbers.data(), answers.data(), texels_of(map)}.*find(function).single)();
  return answers;
}

Answers<double> evaluate_f64(std::string_view function, std::span<const double> numbers, const HeightMap* map) {
  Answers<double> answers{};
  (f64::Bodies{numbers.data(), answers.data(), texels_of(map)}.*find(function).twice)();
  return answers;
}

std::string_view readers_text() { return readers; }

std::string_view body_text(std::string_view function) { return find(function).text; }

}  // namespace terrella::probe
