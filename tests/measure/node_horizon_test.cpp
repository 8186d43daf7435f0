#include "planet/node_horizon.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>

#include "effort.hpp"
#include "laws/random_places.hpp"
#include "measure/ground_models.hpp"
#include "measure/node_picture.hpp"

namespace terrella {
namespace {

using test::Places;
using Triangle = std::array<glm::dvec3, 3>;

// Ranges of real size, without water.
Scene ranges() {
  Scene scene;
  scene.planet.radius = 6.36e6;
  auto& terrain = scene.terrain;
  terrain.height = 20e3;
  terrain.frequency = 4.0;
  terrain.octaves = 16;
  terrain.power = 1.5;
  terrain.ranges = 0.7;
  terrain.range_layer = 3;
  scene.water.model = 0;
  scene.clouds.model = 0;
  scene.quality.pixel_error = 8.0;
  scene.camera.fov = 60.0;
  return scene;
}

void stand_somewhere(Scene& scene, Places& places) {
  auto& camera = scene.camera;
  camera.latitude = places.between(-90.0, 90.0);
  camera.longitude = places.between(-180.0, 180.0);
  camera.heading = places.between(-180.0, 180.0);
  camera.pitch = places.between(-40.0, 15.0);
  const double surface = surface_radius(scene, direction_of(camera.latitude, camera.longitude));
  camera.altitude = (surface - 1.0) * scene.planet.radius + std::pow(10.0, places.between(0.3, 4.5));
}

std::vector<Triangle> triangles_of(const NodePicture& picture, const DrawnNode& drawn) {
  const std::vector<glm::dvec3> vertices = picture.vertices_of(drawn);
  const std::vector<std::uint16_t>& list = picture.triangles_of(drawn, NodePicture::Skirt::without);
  std::vector<Triangle> triangles;
  for (std::size_t i = 0; i < list.size(); i += 3)
    triangles.push_back({vertices[list[i]], vertices[list[i + 1]], vertices[list[i + 2]]});
  return triangles;
}

// Whether a triangle lies between the eye and a place; its edges count as its own, which nodes around the eye turn to
// it.
bool stands_before(const Triangle& t, const glm::dvec3& eye, const glm::dvec3& place) {
  constexpr double rounding = 1e-5;  // vertices are of single precision
  const glm::dvec3 a = t[0] - eye, b = t[1] - eye, c = t[2] - eye, to = place - eye;
  const double u = glm::dot(glm::cross(a, b), to), v = glm::dot(glm::cross(b, c), to),
               w = glm::dot(glm::cross(c, a), to), least = rounding * (std::abs(u) + std::abs(v) + std::abs(w));
  if (std::min({u, v, w}) < -least && std::max({u, v, w}) > least) return false;
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const double part = glm::dot(normal, a) / glm::dot(normal, to);
  return part > 0.0 && part < 1.0;
}

class NodeHorizons : public testing::TestWithParam<Ground> {};

TEST_P(NodeHorizons, LeaveOutOnlyWhatNothingIsSeenOf) {
  Places places(6);
  Scene scene = with_ground(ranges(), GetParam());
  View view;
  view.width = 480;
  view.height = 270;
  std::size_t hidden = 0;
  int looked_at = 0;
  for (int n = 0; n < (test::sanitized ? 2 : 10); ++n) {
    stand_somewhere(scene, places);
    const NodePicture picture(scene, view);
    std::vector<Triangle> drawn;
    for (const DrawnNode& each : picture.drawn()) {
      const std::vector<Triangle> own = triangles_of(picture, each);
      drawn.insert(drawn.end(), own.begin(), own.end());
    }
    const Pose& pose = picture.pose();
    for (const DrawnNode& each : picture.hidden()) {
      ++hidden;
      std::vector<glm::dvec3> vertices = picture.vertices_of(each);
      // What could be seen first.
      std::sort(vertices.begin(), vertices.end(),
                [](const glm::dvec3& a, const glm::dvec3& b) { return glm::length(a) > glm::length(b); });
      for (std::size_t k = 0; k < 4; ++k) {
        const glm::dvec3 from_eye = vertices[k] - pose.eye;
        const double ahead = glm::dot(from_eye, pose.forward), tan = 0.9 * pose.tan_half_fov;
        const double wide = tan * view.width / view.height;
        if (ahead <= 0.0 || std::abs(glm::dot(from_eye, pose.up)) > tan * ahead ||
            std::abs(glm::dot(from_eye, pose.right)) > wide * ahead)
          continue;
        ++looked_at;
        EXPECT_TRUE(std::any_of(drawn.begin(), drawn.end(), [&](const Triangle& triangle) {
          return stands_before(triangle, pose.eye, vertices[k]);
        })) << n;
      }
    }
    if (HasFailure()) FAIL() << n;
  }
  if (test::sanitized) return;
  EXPECT_GT(hidden, 200U);
  EXPECT_GT(looked_at, 200);
}

// From 10 m among mountains a third of the nodes is hidden: 0.33 of the quadtree's, 0.34 and 0.35 of the others.
TEST_P(NodeHorizons, HideMuchAmongMountains) {
  Scene scene = with_ground(ranges(), GetParam());
  View view;
  view.width = 480;
  view.height = 270;
  Places places(7);
  std::size_t drawn = 0, hidden = 0;
  for (int n = 0; n < 8; ++n) {
    stand_somewhere(scene, places);
    const double surface = surface_radius(scene, direction_of(scene.camera.latitude, scene.camera.longitude));
    scene.camera.altitude = (surface - 1.0) * scene.planet.radius + 10.0;
    scene.camera.pitch = -5.0;
    const NodePicture picture(scene, view);
    drawn += picture.drawn().size();
    hidden += picture.hidden().size();
  }
  if (std::getenv("TERRELLA_PRINT") != nullptr)
    std::printf("%s: %zu drawn, %zu hidden\n", std::string(name_of(GetParam())).c_str(), drawn, hidden);
  EXPECT_GT(static_cast<double>(hidden), 0.3 * static_cast<double>(drawn + hidden));
}

INSTANTIATE_TEST_SUITE_P(Of, NodeHorizons, testing::ValuesIn(ground_models()),
                         [](const auto& of) { return std::string(name_of(of.param)); });

}  // namespace
}  // namespace terrella
