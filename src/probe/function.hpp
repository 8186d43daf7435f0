// What the probe's table says of a function.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <random>
#include <span>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "base/height_map.hpp"
#include "base/result.hpp"

namespace terrella::probe {

using Json = nlohmann::ordered_json;

enum class Precision { f64, f32, gpu };

enum class Kind {
  number,
  whole,    // a whole number
  triple,   // [x, y, z]
  spread,   // three numbers, or one that stands for all three
  pair,     // [x, y]
  numbers,  // a list of numbers, at most kLongestList
  word,     // one of `words`
  object,   // with `fields`
  objects,  // a list of objects with `fields`, at most kLongestList
};

// Software rasterizers end a loop after 65,536 turns.
inline constexpr std::size_t kLongestList = 50'000;

struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool open = false;  // whether the ends themselves are not allowed
};

inline constexpr Range any{};
inline constexpr Range positive{0.0, std::numeric_limits<double>::infinity(), true};
inline constexpr Range not_negative{0.0};

// The numbers that a function's body reads, or a sentence.
using Prepared = Result<std::vector<double>>;

// One argument of a function, or one field of an object among them.
struct Arg {
  std::string_view name;
  Kind kind = Kind::number;
  std::string_view unit = {};  // "m"; empty for a pure number
  Range range = any;           // of each number in it
  bool optional = false;
  std::vector<std::string_view> words = {};
  std::vector<Arg> fields = {};
  bool of_host = false;  // read in double precision, and not told to a vertex or a pixel as it is
  bool squared = false;  // in single precision its size is 0 or within squarable
};

// Sizes whose squares and quotients single precision holds.
inline constexpr Range squarable{1e-18, 1e18};

inline Arg of_host(Arg arg) {
  arg.of_host = true;
  return arg;
}

inline Arg squared(Arg arg) {
  arg.squared = true;
  return arg;
}

// One member of the answer: a list of `count` of the numbers that the function put, from `first` on, or a single number
// where count is 0.
struct Output {
  std::string_view name;
  std::size_t first = 0;
  std::size_t count = 0;
  bool null = false;
};

// Arguments for `--fuzz`: the same numbers on every machine.
class Random {
 public:
  explicit Random(unsigned seed) : random_(seed) {}
  double between(double low, double high);      // uniform
  double log_between(double low, double high);  // uniform in its logarithm; 0 < low
  std::size_t below(std::size_t count);
  bool chance(double part) { return between(0.0, 1.0) < part; }
  glm::dvec3 on_sphere();

 private:
  std::mt19937 random_;
};

// What the shader library's numbers may differ by in single precision: `numbers` are those that prepare made, `answers`
// what double precision makes of them.
struct Case {
  std::span<const double> numbers;
  std::span<const double> answers;
  bool gpu;
  const HeightMap* map = nullptr;  // null where the function reads none
};

struct Function {
  std::string_view name;
  std::vector<Arg> args;
  std::vector<Output> outputs = {};

  // The numbers that the function's body (bodies.inc) reads, from arguments that are there and in range: what a host
  // does in double precision before it draws. Fails with a sentence where they contradict each other.
  std::function<Prepared(const Json& args)> prepare;

  // The map that the body reads beside the numbers, from such arguments; a sentence where they make none. Empty where
  // the function reads no map.
  std::function<Result<SharedHeightMap>(const Json& args)> map = {};

  // Where the answer's members depend on the arguments or on what was found; otherwise `outputs` are they.
  std::function<std::vector<Output>(const Json& args, std::span<const double> answers)> shape = {};

  // Arguments from all over the domain, its ends included. What a vertex or a pixel is told is a float's value.
  std::function<Json(Random&)> random;

  // The allowed error of each answer.
  std::function<std::vector<double>(const Case&)> allowed;

  // --fuzz tries it once in so many times: integrals within integrals take long.
  int rarity = 1;
};

// All of them, in the order of the manual.
std::span<const Function> functions();

// Null if there is none of that name.
const Function* find_function(std::string_view name);

}  // namespace terrella::probe
