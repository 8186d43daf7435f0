// The three grounds of a planet of real size against the reference and each other, from eight altitudes, where grids
// have their corners, and with all that lies over a ground. Floors and ceilings hold for each of them and stand a
// little beside the worst that was measured with llvmpipe; `TERRELLA_PRINT=1 images_tests` prints all.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
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

// How near all grounds come to the reference, and to each other.
struct Likeness {
  double psnr;        // dB, at the least
  double flip;        // at the most, as all that follow
  double silhouette;  // parts of the picture
  double distance;    // the 99th percentile, as a part of the true one
  double normal;      // the median, degrees
  double each_other;  // dB, at the least, of any two grounds
};

struct Place {
  const char* name;
  int seed;
  double latitude, longitude, clearance, pitch;
  double relief;  // m, at the least, from the lowest to the highest ground in the middle of the picture
  Likeness likeness;
};

struct PlaceOfPreset {
  const char* name;
  const char* preset;
  double latitude, longitude, clearance, pitch;
  Likeness likeness;
};

// A ground from a height over it or its sea, with as many layers and craters as pixels can show there.
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

// So that lit snow is not cut off at 1, where nothing would tell how it is shaded.
constexpr double exposure_for_snow = -1.0;

// The ground of a planet of real size.
Scene real_ground(const Place& place) {
  Scene scene = test::bare_ground();
  scene.planet.radius = 6.36e6;
  scene.planet.seed = place.seed;
  auto& terrain = scene.terrain;
  terrain.height = 11000.0;
  terrain.frequency = 1.5;
  terrain.power = 2.0;
  terrain.ranges = 0.7;
  terrain.range_layer = 4;
  terrain.ridge_sharpness = 20.0;
  scene.picture.exposure = exposure_for_snow;
  return ground_from(scene, place.latitude, place.longitude, place.clearance, place.pitch);
}

// The same of a moon with craters.
Scene moon_ground(double clearance, double pitch) {
  Scene scene = test::bare_ground();
  const Scene moon = find_preset("craters")->scene;
  scene.planet = moon.planet;
  scene.terrain = moon.terrain;
  return ground_from(scene, 12.0, 20.0, clearance, pitch);
}

// From the lowest to the highest that is seen in the middle of a picture, a third as wide and high.
double relief_in_the_middle(const Image& height) {
  float lowest = INFINITY, highest = -INFINITY;
  for (int y = height.height / 3; y < height.height * 2 / 3; ++y) {
    for (int x = height.width / 3; x < height.width * 2 / 3; ++x) {
      const float here = height.at(x, y)[0];
      if (!std::isfinite(here)) continue;
      lowest = std::min(lowest, here);
      highest = std::max(highest, here);
    }
  }
  return double{highest} - double{lowest};
}

// Draws the scene by each ground. name: of it, to print.
void expect_likeness(const char* name, const Scene& scene, const test::Exact& exact, const Likeness& likeness) {
  std::vector<Image> pictures;
  for (const Ground ground : ground_models()) {
    const Scene drawn = with_ground(scene, ground);
    Renderer renderer;
    const test::Errors errors = errors_of(drawn, renderer, exact);
    pictures.push_back(test::cut_off(test::light_of(drawn, renderer)));
    if (test::prints())
      std::printf("%-26s%-16s %s\n", name, std::string(name_of(ground)).c_str(), text_of(errors).c_str());
    ASSERT_TRUE(std::isfinite(errors.psnr) && std::isfinite(errors.flip));
    EXPECT_GE(errors.psnr, likeness.psnr) << name_of(ground);
    EXPECT_LE(errors.flip, likeness.flip) << name_of(ground);
    EXPECT_LE(errors.geometry.silhouette, likeness.silhouette) << name_of(ground);
    EXPECT_LE(errors.geometry.distance_p99, likeness.distance) << name_of(ground);
    EXPECT_LE(errors.geometry.normal_median, likeness.normal) << name_of(ground);
  }
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const double same = psnr(pictures[i], pictures[(i + 1) % pictures.size()]);
    if (test::prints()) std::printf("%-26seach other %.1f dB\n", name, same);
    EXPECT_GE(same, likeness.each_other);
  }
}

void PrintTo(const Place& place, std::ostream* out) { *out << place.name; }
void PrintTo(const PlaceOfPreset& place, std::ostream* out) { *out << place.name; }

// Corners are looked at from a quarter of a degree south of them, so that they lie in the middle of the picture. Of
// 1,500 planets those were taken whose mountains there are among the steepest.
const Place places[] = {
    {"from_10_m", 7, -41.3, 131.5, 10.0, -6.0, 15.0, {32.1, 0.021, 0.0005, 0.0081, 4.8, 40.3}},
    {"from_100_m", 7, -41.3, 131.5, 100.0, -6.0, 190.0, {33.1, 0.0173, 0.0011, 0.0087, 4.2, 42.3}},
    {"from_1_km", 7, -41.3, 131.5, 1e3, -8.0, 5000.0, {33.4, 0.0163, 0.0009, 0.012, 3.1, 38.8}},
    {"from_10_km", 7, -41.3, 131.5, 1e4, -12.0, 6000.0, {33.9, 0.0151, 0.0011, 0.0088, 3.0, 38.6}},
    {"from_100_km", 7, -41.3, 131.5, 1e5, -20.0, 7500.0, {36.1, 0.011, 0.0008, 0.0065, 2.7, 43.6}},
    {"from_1000_km", 7, -41.3, 131.5, 1e6, -45.0, 7700.0, {39.8, 0.0069, 0.0006, 0.002, 0.84, 45.1}},
    {"from_10000_km", 7, -41.3, 131.5, 1e7, -90.0, 9200.0, {46.4, 0.0025, 0.0006, 0.001, 0.068, 53.7}},
    {"from_40000_km", 7, -41.3, 131.5, 4e7, -90.0, 8500.0, {55.0, 0.0008, 0.0007, 0.003, 0.13, 71.5}},
    {"at_a_pole", 1030, 89.75, 10.0, 1e4, -20.0, 4000.0, {34.2, 0.0197, 0.0011, 0.007, 2.55, 40.8}},
    {"at_the_date_line", 648, 18.75, 180.0, 1e4, -20.0, 5900.0, {30.9, 0.0243, 0.0011, 0.0147, 4.5, 38.0}},
    {"at_a_corner_of_the_cube", 78, 35.01438968, 45.0, 1e4, -20.0, 3300.0, {34.3, 0.0151, 0.0016, 0.0093, 1.9, 41.9}},
    {"at_a_corner_of_triangles", 1130, 26.31505118, 0.0, 1e4, -20.0, 4600.0, {33.2, 0.0169, 0.0013, 0.0091, 3.4, 40.1}},
};

class Grounds : public testing::TestWithParam<Place> {};

TEST_P(Grounds, ShowTheSamePicture) {
  if (test::sanitized) GTEST_SKIP() << test::too_long_sanitized;
  const auto context = EglContext::make(Api::core);
  ASSERT_TRUE(context) << context.sentence();
  const Place& place = GetParam();
  const Scene scene = real_ground(place);
  const test::Exact exact(scene);
  const double relief = relief_in_the_middle(exact.geometry.height);
  if (test::prints()) std::printf("%-26srelief %.0f m\n", place.name, relief);
  EXPECT_GE(relief, place.relief);
  expect_likeness(place.name, scene, exact, place.likeness);
}

INSTANTIATE_TEST_SUITE_P(OfRealSize, Grounds, testing::ValuesIn(places),
                         [](const auto& of) { return std::string(of.param.name); });

// Under air and clouds: a channel between floes, floes from afar; at the date line lakes before mountains, and coasts
// with and without ice. Most of what differs from 20 km lies at the horizon: three quarters of a pixel, by which the
// sea is raised, are hundreds of metres there in so few rows.
const PlaceOfPreset places_of_presets[] = {
    {"blue_at_a_pole_20_km", "blue", 88.6, 150.0, 2e4, -20.0, {25.8, 0.046, 0.006, 0.19, 1.33, 60.5}},
    {"blue_at_a_pole_2000_km", "blue", 86.0, 100.0, 2e6, -55.0, {24.8, 0.069, 0.0006, 0.0049, 1.48, 39.8}},
    {"highlands_at_180_20_km", "highlands", -48.2, 180.0, 2e4, -20.0, {31.2, 0.0535, 0.0027, 0.116, 2.67, 47.2}},
    {"frozen_at_180_2000_km", "frozen", -36.0, 180.0, 2e6, -50.0, {24.2, 0.0505, 0.0003, 0.0037, 0.91, 41.2}},
};

class GroundsOfPresets : public testing::TestWithParam<PlaceOfPreset> {};

TEST_P(GroundsOfPresets, ShowTheSamePicture) {
  if (test::sanitized) GTEST_SKIP() << test::too_long_sanitized;
  const auto context = EglContext::make(Api::core);
  ASSERT_TRUE(context) << context.sentence();
  const PlaceOfPreset& place = GetParam();
  Scene scene = find_preset(place.preset)->scene;
  // Of waves the reference knows all from afar as well, and needs many rays for them: sea_test.cpp looks at those.
  scene.waves.count = 0;
  scene.water.foam = 0.0;
  scene.picture.exposure = exposure_for_snow;
  scene = ground_from(scene, place.latitude, place.longitude, place.clearance, place.pitch);
  expect_likeness(place.name, scene, test::Exact(scene), place.likeness);
}

INSTANTIATE_TEST_SUITE_P(FromAbove, GroundsOfPresets, testing::ValuesIn(places_of_presets),
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
      if (test::prints())
        std::printf("craters %-10g%-16s %s\n", view.clearance, std::string(name_of(ground)).c_str(),
                    text_of(errors).c_str());
      ASSERT_TRUE(std::isfinite(errors.psnr));
      EXPECT_GE(errors.psnr, view.psnr) << name_of(ground) << " " << view.clearance;
    }
  }
}

}  // namespace
}  // namespace terrella
