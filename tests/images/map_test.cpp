// Every ground with continents of a map, against the reference. Floors and ceilings stand a little beside the worst
// that was measured with llvmpipe (TERRELLA_PRINT=1 images_tests prints all).
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "height_maps.hpp"
#include "images/bare_ground.hpp"
#include "images/reference_errors.hpp"
#include "measure/ground_models.hpp"
#include "native/egl_context.hpp"
#include "planet/terrain.hpp"
#include "scene/parameters.hpp"

namespace terrella {
namespace {

// The map of a scene's own ground as its seed makes it, as fine as its texels show.
MapFile map_of(const Scene& scene, int width) {
  const f64::Terrain terrain = exact_terrain_of(scene);
  const int height = width / 2;
  const double texel = 2.0 * std::numbers::pi / width;
  std::vector<float> heights;
  for (int i = 0; i < width * height; ++i) {
    const glm::dvec3 d = test::direction_of_texel(i % width, i / width, width, height);
    heights.push_back(static_cast<float>(f64::terrain_height_at(d, terrain, texel).value / terrain.height));
  }
  return {"own.png", std::make_shared<const HeightMap>(width, height, std::move(heights))};
}

struct Place {
  const char* name;
  double altitude, latitude, longitude, pitch;  // altitude: radii
  double psnr;                                  // dB, at the least
  double flip;                                  // at the most, as all that follow
  double silhouette, distance, normal;
};

void PrintTo(const Place& place, std::ostream* out) { *out << place.name; }

Scene mapped(double radius, const Place& place) {
  Scene scene = test::bare_ground();
  if (radius > 1.0) {
    const double height = 0.0017;
    scene = scaled(scene, radius);
    scene.terrain.height = height * radius;
    scene.water.level = 0.0;
  }
  scene.terrain.octaves = 6;
  scene.terrain.map = map_of(scene, 512);
  scene.camera.altitude = place.altitude * radius;
  scene.camera.latitude = place.latitude;
  scene.camera.longitude = place.longitude;
  scene.camera.pitch = place.pitch;
  scene.sun.latitude = std::fmin(place.latitude, 45.0);
  scene.sun.longitude = place.longitude - 50.0;
  return scene;
}

void expect_near_the_reference(const Scene& scene, const Place& place, const char* ground) {
  const auto context = EglContext::make(Api::core);
  ASSERT_TRUE(context) << context.sentence();
  Renderer renderer;
  const test::Errors errors = test::errors_of(scene, renderer, test::Exact(scene));
  if (test::prints()) std::printf("%-20s %-16s %s\n", place.name, ground, text_of(errors).c_str());
  if (test::sanitized) return;  // floors are those of larger pictures
  EXPECT_GE(errors.psnr, place.psnr) << ground;
  EXPECT_LE(errors.flip, place.flip) << ground;
  EXPECT_LE(errors.geometry.silhouette, place.silhouette) << ground;
  EXPECT_LE(errors.geometry.distance_p99, place.distance) << ground;
  EXPECT_LE(errors.geometry.normal_median, place.normal) << ground;
}

class MapOfMiniature : public testing::TestWithParam<Place> {};

TEST_P(MapOfMiniature, IsNearTheReference) {
  const Place& place = GetParam();
  expect_near_the_reference(mapped(1.0, place), place, "icosphere");
}

const Place miniatures[] = {
    {"far", 2.2, 14.0, 0.0, -90.0, 29.4, 0.0223, 0.0024, 0.0098, 5.5},
    {"near", 0.3, 14.0, 20.0, -35.0, 24.8, 0.034, 0.0037, 0.04, 2.8},
    {"date_line", 0.6, 10.0, 180.0, -70.0, 26.5, 0.0455, 0.003, 0.0215, 2.3},
    {"pole", 0.6, 90.0, 0.0, -70.0, 25.5, 0.047, 0.0039, 0.0175, 2.2},
};

INSTANTIATE_TEST_SUITE_P(Places, MapOfMiniature, testing::ValuesIn(miniatures),
                         [](const auto& of) { return std::string(of.param.name); });

class MapOfRealSize : public testing::TestWithParam<Place> {};

TEST_P(MapOfRealSize, IsNearTheReferenceOnEveryGround) {
  if (test::sanitized) GTEST_SKIP() << test::too_long_sanitized;
  const Place& place = GetParam();
  for (const Ground ground : ground_models()) {
    expect_near_the_reference(with_ground(mapped(6.36e6, place), ground), place, name_of(ground).data());
  }
}

const Place real_sizes[] = {
    {"far", 2.2, 14.0, 0.0, -90.0, 43.3, 0.0082, 0.0003, 0.0028, 0.11},
    {"near", 0.004, 14.0, 20.0, -20.0, 52.0, 0.0031, 0.0001, 0.002, 0.02},
    {"date_line", 0.01, 10.0, 180.0, -30.0, 53.7, 0.0028, 0.0002, 0.0008, 0.02},
    {"pole", 0.01, 90.0, 0.0, -30.0, 90.0, 0.0009, 0.0001, 0.0007, 0.02},
};

INSTANTIATE_TEST_SUITE_P(Places, MapOfRealSize, testing::ValuesIn(real_sizes),
                         [](const auto& of) { return std::string(of.param.name); });

// A planet of the map of itself is the same planet: what its texels can't hold, the same layers of noise add.
TEST(MapOfItself, IsTheSamePlanet) {
  const auto context = EglContext::make(Api::core);
  ASSERT_TRUE(context) << context.sentence();
  Renderer renderer;
  Scene scene = test::bare_ground();
  scene.terrain.octaves = 9;
  const auto picture = [&] {
    return take_measurement(renderer, scene, test::asked_for<StillOptions>(0.0), Channel::color);
  };
  const Image own = picture();
  scene.terrain.map = map_of(scene, 512);
  const double same = psnr(picture(), own);
  scene.terrain.map = {};
  scene.planet.seed = 2;
  const double other = psnr(picture(), own);
  if (test::prints()) std::printf("of itself %.1f dB, another %.1f dB\n", same, other);
  EXPECT_GT(same, 31.4);
  EXPECT_LT(other, 12.0);
}

}  // namespace
}  // namespace terrella
