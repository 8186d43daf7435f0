// The three grounds of a planet of real size against the reference and each other, from eight altitudes and where grids
// have their corners. Floors and ceilings hold for each of them and stand a little beside the worst that was measured
// with llvmpipe; `TERRELLA_PRINT=1 images_tests` prints all.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include <glm/geometric.hpp>

#include "images/bare_ground.hpp"
#include "images/reference_errors.hpp"
#include "measure/ground_models.hpp"
#include "native/egl_context.hpp"
#include "planet/needs.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

struct Place {
  const char* name;
  double latitude, longitude, clearance, pitch;
  double psnr;        // dB, at the least
  double flip;        // at the most, as all that follow
  double silhouette;  // parts of the picture
  double distance;    // the 99th percentile, as a part of the true one
  double normal;      // the median, degrees
  double each_other;  // dB, at the least, of any two grounds
};

// A ground from a height over it, with as many layers and craters as pixels can show there.
Scene ground_from(Scene scene, double latitude, double longitude, double clearance, double pitch) {
  auto& terrain = scene.terrain;
  scene.camera.latitude = latitude;
  scene.camera.longitude = longitude;
  scene.camera.altitude = 0.0;
  scene.camera.pitch = pitch;
  scene.camera.fov = 60.0;
  scene.sun.latitude = latitude > 45.0 ? 45.0 : latitude;
  scene.sun.longitude = longitude - 40.0;
  const double shown = clearance / scene.planet.radius * 4.0 * 2.0 * 0.577 / 90.0;  // of a cell, rad
  terrain.octaves = 0;
  for (double f = terrain.frequency; f * shown < 1.0 && terrain.octaves < 32; f *= terrain.lacunarity)
    ++terrain.octaves;
  terrain.octaves = std::max(terrain.octaves, 5);
  const int most_craters = terrain.crater_sizes;
  terrain.crater_sizes = 0;
  for (double f = terrain.crater_frequency; f64::crater_detail * f * shown < 1.0 && terrain.crater_sizes < most_craters;
       f *= f64::crater_step)
    ++terrain.crater_sizes;
  const double ground = glm::length(pose_of(scene, {}).eye) - 1.0 - least_clearance(scene);
  scene.camera.altitude = ground * scene.planet.radius + clearance;
  return scene;
}

// The ground of a planet of real size.
Scene real_ground(double latitude, double longitude, double clearance, double pitch) {
  Scene scene = test::bare_ground();
  scene.planet.radius = 6.36e6;
  scene.planet.seed = 7;
  auto& terrain = scene.terrain;
  terrain.height = 11000.0;
  terrain.frequency = 1.5;
  terrain.power = 2.0;
  terrain.ranges = 0.7;
  terrain.range_layer = 4;
  terrain.ridge_sharpness = 20.0;
  return ground_from(scene, latitude, longitude, clearance, pitch);
}

// The same of a moon with craters.
Scene moon_ground(double clearance, double pitch) {
  Scene scene = test::bare_ground();
  const Scene moon = find_preset("craters")->scene;
  scene.planet = moon.planet;
  scene.terrain = moon.terrain;
  return ground_from(scene, 12.0, 20.0, clearance, pitch);
}

void PrintTo(const Place& place, std::ostream* out) { *out << place.name; }

const Place places[] = {
    {"from_10_m", -41.3, 131.5, 10.0, -6.0, 35.3, 0.0153, 0.0005, 0.0081, 4.8, 36.1},
    {"from_100_m", -41.3, 131.5, 100.0, -6.0, 36.2, 0.0136, 0.0011, 0.0087, 4.6, 40.1},
    {"from_1_km", -41.3, 131.5, 1e3, -8.0, 33.1, 0.0142, 0.0009, 0.012, 3.7, 34.3},
    {"from_10_km", -41.3, 131.5, 1e4, -12.0, 35.8, 0.0119, 0.0011, 0.0086, 3.2, 36.9},
    {"from_100_km", -41.3, 131.5, 1e5, -20.0, 38.3, 0.0081, 0.0008, 0.0065, 2.7, 42.1},
    {"from_1000_km", -41.3, 131.5, 1e6, -45.0, 43.5, 0.0051, 0.0006, 0.002, 0.9, 47.8},
    {"from_10000_km", -41.3, 131.5, 1e7, -90.0, 47.0, 0.0023, 0.0006, 0.001, 0.068, 51.5},
    {"from_40000_km", -41.3, 131.5, 4e7, -90.0, 55.0, 0.0008, 0.0007, 0.003, 0.13, 71.5},
    {"at_a_pole", 90.0, 10.0, 1e4, -20.0, 80.0, 0.0007, 0.0003, 0.0002, 0.031, 80.0},
    {"at_the_date_line", 19.0, 180.0, 1e4, -20.0, 80.0, 0.0007, 0.0003, 0.00035, 0.042, 80.0},
    {"at_a_corner_of_the_cube", 35.26438968, 45.0, 1e4, -20.0, 80.0, 0.0006, 0.0004, 0.00021, 0.031, 80.0},
    {"at_a_corner_of_triangles", 26.56505118, 0.0, 1e4, -20.0, 34.3, 0.0136, 0.0007, 0.0061, 3.0, 38.5},
};

class Grounds : public testing::TestWithParam<Place> {};

TEST_P(Grounds, ShowTheSamePicture) {
  if (test::sanitized) GTEST_SKIP() << test::too_long_sanitized;
  const auto context = EglContext::make(Api::core);
  ASSERT_TRUE(context) << context.sentence();
  const Place& place = GetParam();
  Scene scene = real_ground(place.latitude, place.longitude, place.clearance, place.pitch);
  const test::Exact exact(scene);
  std::vector<Image> pictures;
  for (const Ground ground : ground_models()) {
    scene = with_ground(scene, ground);
    Renderer renderer;
    const test::Errors errors = errors_of(scene, renderer, exact);
    pictures.push_back(test::cut_off(test::light_of(scene, renderer)));
    if (std::getenv("TERRELLA_PRINT") != nullptr)
      std::printf("%-26s%-16s %s\n", place.name, std::string(name_of(ground)).c_str(), text_of(errors).c_str());
    ASSERT_TRUE(std::isfinite(errors.psnr) && std::isfinite(errors.flip));
    EXPECT_GE(errors.psnr, place.psnr) << name_of(ground);
    EXPECT_LE(errors.flip, place.flip) << name_of(ground);
    EXPECT_LE(errors.geometry.silhouette, place.silhouette) << name_of(ground);
    EXPECT_LE(errors.geometry.distance_p99, place.distance) << name_of(ground);
    EXPECT_LE(errors.geometry.normal_median, place.normal) << name_of(ground);
  }
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const double same = psnr(pictures[i], pictures[(i + 1) % pictures.size()]);
    if (std::getenv("TERRELLA_PRINT") != nullptr) std::printf("%-26seach other %.1f dB\n", place.name, same);
    EXPECT_GE(same, place.each_other);
  }
}

INSTANTIATE_TEST_SUITE_P(OfRealSize, Grounds, testing::ValuesIn(places),
                         [](const auto& of) { return std::string(of.param.name); });

struct OverCraters {
  double clearance, pitch;
  double psnr;  // dB, at the least
};

// Craters pass from pixels to vertices as one comes nearer. In so few pixels vertices stand as near to each other as
// pixels do, and the reference tells those small craters apart that pixels leave out.
TEST(GroundsWithCraters, ShowThemFromOrbitToTheRimOfOne) {
  if (test::sanitized) GTEST_SKIP() << test::too_long_sanitized;
  const auto context = EglContext::make(Api::core);
  ASSERT_TRUE(context) << context.sentence();
  // Measured: 43.0 to 44.2, 39.5 to 39.8, 38.5 to 38.8.
  for (const OverCraters& view : {OverCraters{3e6, -90.0, 42.6}, {1e5, -14.0, 39.2}, {5e3, -12.0, 38.2}}) {
    const Scene scene = moon_ground(view.clearance, view.pitch);
    const test::Exact exact(scene);
    for (const Ground ground : ground_models()) {
      const Scene drawn = with_ground(scene, ground);
      Renderer renderer;
      const test::Errors errors = errors_of(drawn, renderer, exact);
      if (std::getenv("TERRELLA_PRINT") != nullptr)
        std::printf("craters %-10g%-16s %s\n", view.clearance, std::string(name_of(ground)).c_str(),
                    text_of(errors).c_str());
      ASSERT_TRUE(std::isfinite(errors.psnr));
      EXPECT_GE(errors.psnr, view.psnr) << name_of(ground) << " " << view.clearance;
    }
  }
}

}  // namespace
}  // namespace terrella
