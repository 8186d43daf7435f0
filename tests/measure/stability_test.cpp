// Planted movements must be measured.
#include "measure/stability.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <vector>

namespace terrella {
namespace {

constexpr int width = 40, height = 30;

std::vector<float> picture(const std::function<double(double, double)>& value) {
  std::vector<float> pixels;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) pixels.insert(pixels.end(), 4, static_cast<float>(value(x, y)));
  }
  return pixels;
}

double hill(double x, double y) { return 3.0 + 0.02 * x + 0.01 * y + 0.0002 * x * x; }

TEST(Jitter, IsByHowMuchASurfaceMoved) {
  const auto before = picture(hill);
  for (const double moved : {0.0, 0.004, 0.05, 0.5}) {
    const auto after = picture([&](double x, double y) { return hill(x - moved, y); });
    const Jitter jitter = jitter_between(before, after, width, height, 1, 0.0);
    EXPECT_NEAR(jitter.largest, moved, 0.1 * moved + 2e-4);  // the slope's share along y is not the movement's
    EXPECT_LE(jitter.nearly_all, jitter.largest);
    EXPECT_EQ(jitter.measured, 1.0);
    EXPECT_EQ(jitter.planet, (width - 2) * (height - 2));
  }
}

TEST(Jitter, OfASinglePixelIsSeen) {
  const auto before = picture(hill);
  auto after = before;
  after[4 * (10 * width + 10)] += 0.01F;  // where the slope is 0.0261
  const Jitter jitter = jitter_between(before, after, width, height, 1, 0.0);
  EXPECT_NEAR(jitter.largest, 0.38, 0.02);
  EXPECT_EQ(jitter.nearly_all, 0.0);
  after[4 * (10 * width + 10)] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(jitter_between(before, after, width, height, 1, 0.0).largest, std::numeric_limits<double>::infinity());
}

TEST(Jitter, LeavesOutEdgesAndWhatIsLevel) {
  const auto step = [](double x, double) { return x < 20.0 ? 2.0 : 3.0; };
  EXPECT_EQ(jitter_between(picture(step), picture(step), width, height, 1, 0.0).measured, 0.0);
  const auto sky = [](double, double) { return std::numeric_limits<double>::infinity(); };
  EXPECT_EQ(jitter_between(picture(sky), picture(sky), width, height, 1, 0.0).planet, 0);
}

TEST(Jitter, LeavesTheAllowanceToMovesTowardsTheEye) {
  const auto before = picture(hill), after = picture([](double x, double y) { return hill(x, y) + 1e-3; });
  EXPECT_GT(jitter_between(before, after, width, height, 1, 0.0).largest, 0.02);
  EXPECT_LT(jitter_between(before, after, width, height, 1, 1.1e-3).largest, 1e-4);
}

std::vector<float> wave_at(double phase) {
  return picture([&](double x, double y) { return std::sin(0.3 * x + 0.1 * y + phase); });
}

TEST(Motion, IsEvenWhereAWaveRunsOnAndNotWhereItStumbles) {
  const Motion even = motion_between(wave_at(0.0), wave_at(0.01), wave_at(0.02));
  EXPECT_GT(even.change, 1e-3);
  EXPECT_LT(even.unrest, 0.05);
  // As where time is known to every other frame only.
  const Motion stumbling = motion_between(wave_at(0.0), wave_at(0.0), wave_at(0.02));
  EXPECT_NEAR(stumbling.unrest, std::sqrt(2.0), 0.05);
  EXPECT_EQ(motion_between(wave_at(0.0), wave_at(0.0), wave_at(0.0)).change, 0.0);
}

TEST(Motion, OfNoiseIsUnrest) {
  std::mt19937 random(3U);
  std::normal_distribution<double> noise;
  const auto make = [&] { return picture([&](double, double) { return 0.01 * noise(random); }); };
  const auto a = make(), b = make(), c = make();
  EXPECT_GT(motion_between(a, b, c).unrest, 1.4);
}

TEST(LightPsnr, IsThatOfTheMeanSquare) {
  std::vector<float> a(8, 0.5F), b = a;
  EXPECT_EQ(light_psnr(a, b), std::numeric_limits<double>::infinity());
  b[3] = 0.75F;
  EXPECT_NEAR(light_psnr(a, b), 21.07, 0.01);
}

}  // namespace
}  // namespace terrella
