// Laws of the reference's pictures.
#include "reference/picture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/numbers.hpp"
#include "effort.hpp"
#include "scene/parameters.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

reference::Options small(int threads = 0) {
  reference::Options options;
  options.width = test::sanitized ? 16 : 48;
  options.height = test::sanitized ? 9 : 27;
  options.seconds = 3.0;
  options.threads = threads;
  return options;
}

// What looks the same from every side: a sea of ripples or none, air, and no noise.
Scene turnable() {
  Scene scene;
  scene.terrain.model = 0;
  scene.clouds.model = 0;
  scene.stars.model = 0;
  scene.water.ripples = 0.0;
  scene.sun.latitude = 0.0;
  scene.camera.latitude = 0.0;
  return scene;
}

TEST(Reference, DrawsTheSameWhateverTheNumberOfThreads) {
  const Scene scene;
  const Image one = reference::light(scene, small(1)), three = reference::light(scene, small(3));
  EXPECT_EQ(one.pixels, three.pixels);
  const auto a = reference::geometry(scene, small(1)), b = reference::geometry(scene, small(4));
  EXPECT_EQ(a.distance.pixels, b.distance.pixels);
  EXPECT_EQ(a.normal.pixels, b.normal.pixels);
  EXPECT_EQ(a.height.pixels, b.height.pixels);
}

TEST(Reference, TellsHowFarItIs) {
  reference::Options options = small();
  double last = -1.0;
  options.progress = [&](double part) {
    EXPECT_GE(part, last);
    EXPECT_LE(part, 1.0);
    last = part;
  };
  reference::geometry(Scene{}, options);
  EXPECT_EQ(last, 1.0);
}

TEST(Reference, OfEveryPresetIsFinite) {
  reference::Options options = small();
  options.width = 24;
  options.height = 14;
  for (const Preset& preset : presets()) {
    SCOPED_TRACE(preset.name);
    EXPECT_TRUE(all_finite(reference::light(preset.scene, options).pixels));
    EXPECT_TRUE(all_finite(reference::geometry(preset.scene, options).normal.pixels));
  }
}

// Powers of two change no digit but exponents. The exceptions are lengths that are held (least_clearance), of which a
// scene from afar has none.
TEST(Reference, OfAScaledSceneIsTheSame) {
  const Scene scene;
  const Image as_it_is = reference::light(scene, small());
  for (const int power : {-10, 20}) {
    const double factor = std::ldexp(1.0, power);
    const Scene large = scaled(scene, factor);
    EXPECT_LT(largest_difference(as_it_is.pixels, reference::light(large, small()).pixels), 1e-6) << power;
    const auto before = reference::geometry(scene, small()).distance,
               after = reference::geometry(large, small()).distance;
    for (std::size_t i = 0; i < before.pixels.size(); ++i) {
      if (std::isfinite(before.pixels[i])) {
        ASSERT_NEAR(double{after.pixels[i]}, double{before.pixels[i]} * factor, 1e-6 * factor);
      } else {
        ASSERT_EQ(after.pixels[i], before.pixels[i]);
      }
    }
  }
}

TEST(Reference, OfATurnedSceneIsTheSame) {
  Scene scene = turnable();
  const Image before = reference::light(scene, small());
  scene.camera.longitude += 57.0;
  scene.sun.longitude += 57.0;
  EXPECT_LT(largest_difference(before.pixels, reference::light(scene, small()).pixels), 1e-6);
  // And turned about another axis: from over the equator to over a pole, where headings turn with it.
  Scene equator = turnable(), pole = turnable();
  equator.camera.longitude = 0.0;
  equator.camera.heading = 0.0;  // up in the picture is north
  equator.sun.longitude = 0.0;
  equator.sun.latitude = 30.0;  // as far up in the picture
  pole.camera.latitude = 90.0;
  pole.camera.longitude = 0.0;
  pole.camera.heading = 0.0;  // up in the picture is where longitude 180 is
  pole.sun.latitude = 60.0;
  pole.sun.longitude = 180.0;
  EXPECT_LT(largest_difference(reference::light(equator, small()).pixels, reference::light(pole, small()).pixels),
            1e-6);
}

TEST(Reference, NormalsAreUnitAndFaceTheEyeOnASphere) {
  const Scene scene = turnable();
  const auto seen = reference::geometry(scene, small());
  int on_planet = 0;
  for (int y = 0; y < seen.distance.height; ++y) {
    for (int x = 0; x < seen.distance.width; ++x) {
      const float* n = seen.normal.at(x, y);
      const double length = glm::length(glm::dvec3(n[0], n[1], n[2]));
      const bool sky = std::isinf(*seen.distance.at(x, y));
      ASSERT_NEAR(length, sky ? 0.0 : 1.0, 1e-6);
      if (sky) continue;
      ++on_planet;
      ASSERT_NEAR(double{*seen.height.at(x, y)}, scene.water.level, 1e-6);
    }
  }
  EXPECT_GT(on_planet, test::sanitized ? 10 : 100);
}

// The mean over a pixel is what more samples come closer to.
TEST(Reference, ConvergesWithItsSamples) {
  if (test::sanitized) GTEST_SKIP() << test::too_long_sanitized;
  Scene scene;
  scene.terrain.octaves = 5;
  reference::Options options = small();
  options.samples = 6;
  const Image fine = reference::light(scene, options);
  double last = 1e9;
  for (const int samples : {1, 2, 4}) {
    options.samples = samples;
    const Image image = reference::light(scene, options);
    double squares = 0.0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
      squares += std::pow(double{image.pixels[i]} - double{fine.pixels[i]}, 2);
    EXPECT_LT(squares, 0.6 * last) << samples;
    last = squares;
  }
}

}  // namespace
}  // namespace terrella
