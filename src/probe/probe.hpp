// Single functions of the shader library, evaluated for whoever asks: JSON lines in, JSON lines out.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "probe/function.hpp"
#include "probe/gpu.hpp"
#include "probe/line.hpp"

namespace terrella::probe {

class Probe {
 public:
  // open_gpu makes a context current for as long as the probe lives, and returns whether this machine has one. It is
  // asked once, when a GPU is first needed.
  explicit Probe(std::function<bool()> open_gpu) : open_gpu_(std::move(open_gpu)) {}

  // One answer for each line, in the same order, without line ends. A line is
  //   {"id": any, "fn": "horizon", "args": {...}, "precision": "f64"|"f32"|"gpu"}
  // and its answer {"id": any, "value": {...}} or {"id": any, "error": "a sentence"}; without a precision it is f64.
  // What several lines ask of one function's GPU version is drawn at once.
  std::vector<std::string> answer(std::span<const std::string> lines);

  // Null where there is none.
  Gpu* gpu();

 private:
  std::function<bool()> open_gpu_;
  bool asked_ = false;
  std::unique_ptr<Gpu> gpu_;
};

// What single precision computes from numbers that were prepared in double: each is rounded.
std::vector<float> rounded_numbers(std::span<const double> numbers);

// How far single precision and the driver are from double precision.
struct Accuracy {
  std::string_view function;
  int tries = 0;
  double f32 = 0.0;         // the worst error of any answer, as a part of what is allowed
  double gpu = 0.0;         // the same, negative where there is no GPU
  std::string worst_f32{};  // the arguments of that, as JSON
  std::string worst_gpu{};
};

// Tries each function on n sets of arguments from all over its domain; integrals on fewer, at least 8. An answer that
// is not finite counts as infinitely wrong. gpu may be null.
std::vector<Accuracy> fuzz(int n, unsigned seed, Gpu* gpu);

// The same as lines for reading, or as the table of docs/numerics.md.
std::string accuracy_text(std::span<const Accuracy> accuracies);
std::string accuracy_markdown(std::span<const Accuracy> accuracies);

}  // namespace terrella::probe
