// What each technique draws against the reference, at several zooms. Floors and ceilings stand a little beside what was
// measured with llvmpipe (the figures in the table's comments); `TERRELLA_PRINT=1 images_tests` prints them anew.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <string>

#include <glm/geometric.hpp>

#include "images/bare_ground.hpp"
#include "images/reference_errors.hpp"
#include "native/egl_context.hpp"
#include "planet/pose.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

using test::bare_ground;
using test::Errors;
using test::errors_of;

Scene seen_from(Scene scene, double altitude, double pitch) {
  scene.camera.altitude = altitude;
  scene.camera.pitch = pitch;
  return scene;
}

// From a little over the ground, so that none of it rises near by. pitch: degrees.
Scene seen_from_a_hill(double pitch) {
  Scene scene = seen_from(bare_ground(), 0.0, pitch);
  scene.camera.altitude = (glm::length(pose_over_coarse_ground(scene, {}).eye) - 1.0) * scene.planet.radius;
  return scene;
}

Scene preset_scene(const char* name) { return find_preset(name)->scene; }

struct Case {
  const char* name;
  std::function<Scene()> scene;
  double psnr;        // at least
  double flip;        // at most, as all that follow
  double silhouette;  // part of the pixels
  double distance;    // relative, of 99 % of the pixels
  double normal;      // deg, of half of the pixels
};

const Case cases[] = {
    {"ground_far", [] { return seen_from(bare_ground(), 2.2, -90.0); }, 31.1, 0.025, 0.0023, 0.012, 1.8},
    {"ground_middle", [] { return seen_from(bare_ground(), 0.5, -50.0); }, 30.7, 0.027, 0.0033, 0.023, 0.38},
    {"ground_near", [] { return seen_from(bare_ground(), 0.15, -25.0); }, 36.6, 0.012, 0.0014, 0.02, 0.2},
    {"ground_of_many_layers",
     [] {
       Scene scene = seen_from(bare_ground(), 0.12, -20.0);
       scene.terrain.octaves = 9;
       return scene;
     },
     27.2, 0.049, 0.0048, 0.052, 8.2},
    {"craters",
     [] {
       Scene scene = seen_from(bare_ground(), 0.6, -60.0);
       scene.terrain.craters = 1.0;
       scene.terrain.crater_sizes = 4;
       return scene;
     },
     27.8, 0.038, 0.0023, 0.025, 0.61},
    {"calm_sea",
     [] {
       Scene scene = bare_ground();
       scene.water.model = 1;
       scene.water.ripples = 0.0;
       return scene;
     },
     24.6, 0.054, 0.0084, 0.052, 2.5},
    {"rippled_sea",
     [] {
       Scene scene = seen_from(bare_ground(), 0.2, -40.0);
       scene.water.model = 1;
       return scene;
     },
     33.9, 0.042, 0.0033, 0.03, 2.2},
    {"waves",
     [] {
       Scene scene = seen_from(bare_ground(), 0.5, -50.0);
       scene.water.model = 3;
       scene.terrain.model = 0;
       scene.waves.count = 8;
       return scene;
     },
     46.6, 0.013, 0.002, 0.011, 1.7},
    {"waves_at_a_shore",
     [] {
       Scene scene = seen_from(bare_ground(), 0.3, -45.0);
       scene.water.model = 3;
       scene.waves.count = 4;
       return scene;
     },
     33.0, 0.047, 0.0033, 0.044, 1.9},
    {"clouds",
     [] {
       Scene scene = bare_ground();
       scene.clouds.model = 1;
       return scene;
     },
     29.6, 0.032, 0.002, 0.011, 1.8},
    {"clouds_from_below",
     [] {
       Scene scene = seen_from_a_hill(25.0);
       scene.clouds.model = 1;
       return scene;
     },
     28.2, 0.13, 0.0005, 0, 0},
    {"air",
     [] {
       Scene scene = bare_ground();
       scene.air.model = 1;
       return scene;
     },
     32.5, 0.022, 0.002, 0.011, 1.8},
    {"air_from_within",
     [] {
       Scene scene = seen_from_a_hill(5.0);
       scene.air.model = 1;
       return scene;
     },
     32.9, 0.021, 0.0083, 0.22, 0.21},
    {"stars",
     [] {
       Scene scene = bare_ground();
       scene.stars.model = 1;
       return scene;
     },
     30.9, 0.025, 0.002, 0.011, 1.8},
    {"sun",
     [] {
       Scene scene = seen_from(bare_ground(), 2.2, -90.0);
       scene.sun.size = 6.0;
       scene.sun.glare = 0.6;
       scene.sun.longitude = scene.camera.longitude + 180.0 + 38.0;
       scene.sun.latitude = -scene.camera.latitude;
       return scene;
     },
     42.1, 0.012, 0.0023, 0.012, 1.8},
    {"temperate", [] { return preset_scene("temperate"); }, 25.0, 0.068, 0.0086, 0.05, 9.4},
    {"archipelago", [] { return preset_scene("archipelago"); }, 21.9, 0.094, 0.0092, 0.055, 5.9},
    {"alps", [] { return preset_scene("alps"); }, 16.2, 0.17, 0.0094, 0.3, 35},
    {"storm", [] { return preset_scene("storm"); }, 21.8, 0.11, 0.0077, 0.066, 14},
    {"dusk", [] { return preset_scene("dusk"); }, 28.8, 0.037, 0.003, 0.055, 3.3},
    {"night", [] { return preset_scene("night"); }, 29.2, 0.075, 0.0074, 0.046, 7.2},
    {"ocean", [] { return preset_scene("ocean"); }, 24.6, 0.078, 0.015, 0.052, 4.6},
    {"rings", [] { return preset_scene("rings"); }, 20.7, 0.14, 0.0083, 0.043, 6.4},
    {"desert", [] { return preset_scene("desert"); }, 19.4, 0.16, 0.0056, 0.029, 45},
    {"ice", [] { return preset_scene("ice"); }, 17.5, 0.17, 0.007, 0.056, 24},
    {"moon", [] { return preset_scene("moon"); }, 29.5, 0.054, 0.0023, 0.013, 15},
    {"lava", [] { return preset_scene("lava"); }, 18.6, 0.13, 0.0061, 0.053, 45},
};

class AgainstReference : public testing::TestWithParam<Case> {};

TEST_P(AgainstReference, IsWithinItsFloor) {
  if (test::sanitized) GTEST_SKIP() << test::too_long_sanitized;
  const auto context = EglContext::make(Api::core);
  ASSERT_TRUE(context) << context.sentence();
  Renderer renderer;
  const Case& wanted = GetParam();
  const Errors errors = errors_of(wanted.scene(), renderer, test::Exact(wanted.scene()));
  if (test::prints()) std::printf("%-24s %s\n", wanted.name, text_of(errors).c_str());
  ASSERT_TRUE(std::isfinite(errors.psnr) && std::isfinite(errors.flip));
  EXPECT_GE(errors.psnr, wanted.psnr);
  EXPECT_LE(errors.flip, wanted.flip);
  EXPECT_LE(errors.geometry.silhouette, wanted.silhouette);
  EXPECT_LE(errors.geometry.distance_p99, wanted.distance);
  EXPECT_LE(errors.geometry.normal_median, wanted.normal);
}

INSTANTIATE_TEST_SUITE_P(Techniques, AgainstReference, testing::ValuesIn(cases),
                         [](const auto& of) { return std::string(of.param.name); });

// What is left beside the reference comes from the mesh and the maps: it falls as they grow finer. What did not would
// be a mistake.
class Refined : public testing::TestWithParam<Case> {};

TEST_P(Refined, ComesCloserToTheReference) {
  if (test::sanitized) GTEST_SKIP() << test::too_long_sanitized;
  const auto context = EglContext::make(Api::core);
  ASSERT_TRUE(context) << context.sentence();
  struct Setting {
    double pixel_error;
    int texels;
  };
  const Case& wanted = GetParam();
  std::vector<Errors> all;
  for (const auto& [pixel_error, texels] : {Setting{3.0, 96}, Setting{0.75, 320}, Setting{0.1, 1024}}) {
    Scene scene = wanted.scene();
    scene.quality.pixel_error = pixel_error;
    scene.quality.ground_texels = scene.quality.cloud_texels = texels;
    Renderer renderer;
    all.push_back(errors_of(scene, renderer, test::Exact(scene)));
    if (test::prints())
      std::printf("%-24s %4.2f px, %4d texels: %s\n", wanted.name, pixel_error, texels, text_of(all.back()).c_str());
  }
  const Errors &first = all.front(), &middle = all[1], &last = all.back();
  // Seen from afar the coarsest setting is already the middle one: no mesh and no mipmap is coarser.
  EXPECT_GT(middle.psnr, first.psnr - 0.5);
  EXPECT_LT(middle.geometry.distance_p99, 1.05 * first.geometry.distance_p99);
  EXPECT_GT(last.psnr, first.psnr + 3.0);
  EXPECT_LT(last.flip, 0.8 * first.flip);
  EXPECT_LT(last.geometry.distance_p99, 0.35 * first.geometry.distance_p99);
  EXPECT_GE(last.psnr, wanted.psnr);
  EXPECT_LE(last.flip, wanted.flip);
  EXPECT_LE(last.geometry.silhouette, wanted.silhouette);
  EXPECT_LE(last.geometry.distance_p99, wanted.distance);
  EXPECT_LE(last.geometry.normal_median, wanted.normal);
}

const Case refined[] = {
    {"ground", [] { return seen_from(bare_ground(), 2.2, -90.0); }, 37.0, 0.014, 0.001, 0.0032, 1.5},
    {"ground_at_the_horizon", [] { return seen_from(bare_ground(), 0.4, -35.0); }, 45.2, 0.0031, 0.0005, 0.0028, 0.09},
    {"sea",
     [] {
       Scene scene = bare_ground();
       scene.water.model = 1;
       scene.water.ripples = 0.0;
       return scene;
     },
     34.0, 0.025, 0.0005, 0.0066, 0.6},
    {"waves_from_low",  // too short for the mesh that pictures have by default
     [] {
       Scene scene = seen_from(bare_ground(), 0.1, -20.0);
       scene.water.model = 3;
       scene.terrain.model = 0;
       scene.waves.count = 8;
       return scene;
     },
     51.8, 0.012, 0.0008, 0.0132, 0.27},
    {"clouds_and_air",
     [] {
       Scene scene = bare_ground();
       scene.clouds.model = scene.air.model = 1;
       return scene;
     },
     32.3, 0.023, 0.0006, 0.003, 1.5},
};

INSTANTIATE_TEST_SUITE_P(Techniques, Refined, testing::ValuesIn(refined),
                         [](const auto& of) { return std::string(of.param.name); });

// Between two pictures of the clouds, which are blended, they are nearly as good as at the time of one of them.
TEST(CloudsBlendedInTime, AreThoseOfTheReference) {
  if (test::sanitized) GTEST_SKIP() << test::too_long_sanitized;
  const auto context = EglContext::make(Api::core);
  ASSERT_TRUE(context) << context.sentence();
  Renderer renderer;
  Scene scene = bare_ground();
  scene.clouds.model = 1;
  scene.terrain.model = 0;
  const auto psnr_at = [&](double time) {
    const auto still = test::asked_for<StillOptions>(time);
    const auto exact = test::asked_for<reference::Options>(time);
    return psnr(test::cut_off(take_measurement(renderer, scene, still, Channel::color)),
                test::cut_off(reference::light(scene, exact)));
  };
  psnr_at(0.0);
  const double interval = renderer.needs().cloud_interval;
  ASSERT_GT(interval, 0.0);
  const double at_step = psnr_at(3.0 * interval), between = psnr_at(3.5 * interval);
  if (test::prints()) std::printf("clouds at a step %.1f dB, between %.1f dB\n", at_step, between);
  EXPECT_GT(between, at_step - 1.0);  // measured: 0.75
}

}  // namespace
}  // namespace terrella
