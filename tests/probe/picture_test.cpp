// The formulas of the picture by way of the probe: what they answer, and that their bounds follow from their form.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "probe/evaluate.hpp"
#include "probe/function.hpp"

namespace terrella::probe {
namespace {

constexpr double u = 0x1p-24;

struct Answered {
  std::vector<double> values;
  std::vector<double> allowed;
};

Answered ask(const char* name, const Json& args) {
  const Function* function = find_function(name);
  const Prepared numbers = function->prepare(args);
  const Answers<double> answers = evaluate_f64(name, *numbers);
  return {{answers.begin(), answers.end()}, function->allowed({*numbers, answers, false})};
}

// A wave from a pole, seen on the equator, where it has its whole height.
Answered wave(double wavenumber, double phase) {
  const Json one = {{"origin", {0, 0, 1}}, {"A", 0.01}, {"w", wavenumber}, {"phase", phase}, {"pinch", 0.0}};
  return ask("swell", {{"v", {1, 0, 0}}, {"waves", Json::array({one})}});
}

TEST(PictureFormulas, AWaveRisesWithItsPhase) {
  const double arc = std::acos(0.0);
  const Answered answered = wave(40.0, 1.0);
  EXPECT_NEAR(answered.values[0], 0.01 * std::sin(40.0 * arc + 1.0), 1e-12);
  EXPECT_NEAR(std::hypot(answered.values[4], answered.values[6]), 0.4 * std::fabs(std::cos(40.0 * arc + 1.0)), 1e-9);
  EXPECT_EQ(ask("swell", {{"v", {1, 0, 0}}, {"waves", Json::array()}}).values[0], 0.0);
}

TEST(PictureFormulas, AWavesErrorGrowsWithItsWavenumber) {
  // Where it passes 0 its height changes by A w an arc, and the arc is told by the place, by the origin and by w.
  for (const double w : {100.0, 1e4}) {
    const Answered answered = wave(w, 0.0);
    EXPECT_GT(answered.allowed[0], 8.0 * u * 0.01 * w);
    EXPECT_LT(answered.allowed[0], 64.0 * u * 0.01 * w);
  }
}

TEST(PictureFormulas, BoundsOfPlainFormulasAreAFewRoundings) {
  const Answered white = ask("srgb", {{"light", 1.0}});
  EXPECT_NEAR(white.values[0], 1.0, 4e-5);
  EXPECT_LT(white.allowed[0], 16.0 * u);
  const Answered half = ask("tone_map", {{"light", 1.0}, {"curve", "reinhard"}});
  EXPECT_NEAR(half.values[1], 0.5, 1e-12);
  EXPECT_LT(half.allowed[1], 16.0 * u);
  const Answered thick = ask("cloud_thickness", {{"noise", 1.0}, {"coverage", 0.5}, {"softness", 0.0}});
  EXPECT_EQ(thick.values[0], 1.0);
  EXPECT_LT(thick.allowed[0], 16.0 * u);
}

TEST(PictureFormulas, ArgumentsAreMadeUpToTheirEnds) {
  Random random(1U);
  bool none = false, whole = false;
  for (int i = 0; i < 200; ++i) {
    const Json args = find_function("cloud_thickness")->random(random);
    none = none || args["coverage"] == 0.0;
    whole = whole || args["coverage"] == 1.0;
  }
  EXPECT_TRUE(none);
  EXPECT_TRUE(whole);
}

}  // namespace
}  // namespace terrella::probe
