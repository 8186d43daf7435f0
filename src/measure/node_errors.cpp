#include "measure/node_errors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <glm/geometric.hpp>

#include "base/check.hpp"
#include "measure/seen_places.hpp"
#include "measure/skyline.hpp"

namespace terrella {
namespace {

class Chance {
 public:
  double part() { return static_cast<double>(random_()) / 4294967296.0; }

  // The first corner of one of a node's triangles, in their list.
  std::size_t triangle_of(const std::vector<std::uint16_t>& triangles) {
    return 3 * static_cast<std::size_t>(part() * static_cast<double>(triangles.size() / 3));
  }

  // Uniform over a triangle, by the parts of its corners.
  glm::dvec3 place_in_triangle() {
    const double towards = std::sqrt(part()), along = part();
    return {1.0 - towards, towards * (1.0 - along), towards * along};
  }

 private:
  std::mt19937 random_{3U};
};

using Corners = std::array<glm::dvec3, 3>;

// Twice the triangle's area, outwards.
glm::dvec3 normal_of(const Corners& corners) { return glm::cross(corners[1] - corners[0], corners[2] - corners[0]); }

bool turns_to(const Corners& corners, const glm::dvec3& eye) {
  return glm::dot(normal_of(corners), eye - corners[0]) > 0.0;
}

// That a triangle covers which is as far away as one of its places.
double pixels_of(const Corners& corners, const glm::dvec3& place, const Pose& pose) {
  const glm::dvec3 to_eye = pose.eye - place;
  const double distance = glm::length(to_eye), pixel = pose.pixel_angle * distance;
  return 0.5 * std::abs(glm::dot(normal_of(corners), to_eye)) / (distance * pixel * pixel);
}

// As in shaders/frame_block.glsl. footprint: of a pixel that looks straight down, pixels.
double pixel_footprint(const glm::dvec3& place, const Pose& pose, double footprint) {
  const glm::dvec3 to_eye = pose.eye - place;
  const double away = glm::length(to_eye), cosine = glm::dot(to_eye, glm::normalize(place)) / away;
  return footprint * away * pose.pixel_angle / std::max(cosine, 0.12);
}

// The ground itself, as far as the picture can show it.
class TrueGround {
 public:
  // footprint: of samples, pixels.
  TrueGround(const NodePicture& picture, const SeenPlaces& seen, double footprint)
      : pose_(picture.pose()), terrain_(picture.terrain()), seen_(seen), footprint_(footprint) {}

  [[nodiscard]] double pixel_at(const glm::dvec3& place) const {
    return pose_.pixel_angle * glm::distance(place, pose_.eye);
  }

  // By how much a place lies over it.
  [[nodiscard]] double over(const glm::dvec3& place) const {
    const double radius = glm::length(place);
    return radius - 1.0 - f64::terrain_height_at(place / radius, terrain_, footprint_ * pixel_at(place)).value;
  }

  // How far apart the picture has a place and the ground above or below it, pixels.
  [[nodiscard]] double seen_over(const glm::dvec3& place, double over) const {
    return glm::distance(seen_.pixel_of(place), seen_.pixel_of(place - over * glm::normalize(place)));
  }

  // How far it rises before what lies at a distance along a ray from the eye, pixels.
  [[nodiscard]] double rises_before(const glm::dvec3& ray, double distance) const {
    double most = 0.0, at = 0.05 * pose_.clearance;
    while (at < distance) {
      const glm::dvec3 place = pose_.eye + at * ray;
      const double over_there = over(place);
      if (over_there < 0.0) most = std::max(most, seen_over(place, over_there));
      // Slopes are hardly steeper than 1.
      at += std::max(0.7 * std::abs(over_there), 2.0 * pose_.pixel_angle * at);
    }
    return most;
  }

 private:
  const Pose& pose_;
  const f64::Terrain& terrain_;
  const SeenPlaces& seen_;
  double footprint_;
};

// Rays that no triangle meets, but the ground does.
void add_sky(const NodePicture& picture, const SeenPlaces& seen, const GroundSkyline& skyline, const TrueGround& ground,
             int rays, Chance& chance, std::vector<NodeError>& errors) {
  const Pose& pose = picture.pose();
  const glm::dvec2 size(picture.view().width, picture.view().height);
  const double highest = 1.0 + picture.terrain().height;
  for (int i = 0; i < rays; ++i) {
    const double x = chance.part(), y = chance.part();
    const glm::dvec3 ray = seen.ray_to((glm::dvec2(x, y) - 0.5) * size);
    if (seen.is_solid_along(ray) || skyline.hides(pose.eye + ray)) continue;
    // To where it leaves the sphere of the highest mountains.
    const double middle = -glm::dot(pose.eye, ray);
    const double half_square = highest * highest - glm::dot(pose.eye, pose.eye) + middle * middle;
    if (half_square <= 0.0) continue;
    const double off = ground.rises_before(ray, middle + std::sqrt(half_square));
    if (off > 0.0) errors.push_back({off, off, size.x * size.y / rays});
  }
}

}  // namespace

double percentile(std::vector<NodeError> errors, double NodeError::*of, double part) {
  CHECK(!errors.empty());
  std::sort(errors.begin(), errors.end(), [&](const NodeError& a, const NodeError& b) { return a.*of < b.*of; });
  double all = 0.0;
  for (const NodeError& error : errors) all += error.pixels;
  double below = 0.0;
  for (const NodeError& error : errors) {
    below += error.pixels;
    if (below >= part * all) return error.*of;
  }
  return errors.back().*of;
}

std::vector<NodeError> node_errors(const NodePicture& picture, int places, double footprint) {
  const Pose& pose = picture.pose();
  const SeenPlaces seen(picture.scene(), picture.view(), pose, picture.needs());
  const TrueGround ground(picture, seen, footprint);
  GroundSkyline skyline(pose.eye);
  Chance chance;
  std::vector<NodeError> errors;
  const std::size_t in_each = static_cast<std::size_t>(places) / std::max<std::size_t>(picture.drawn().size(), 1) + 1;
  for (const DrawnNode& drawn : picture.drawn()) {
    if (!picture.shows(NodeLayer::ground, drawn)) continue;
    const std::vector<ToldGround> vertices = picture.told_by(drawn);
    const std::vector<std::uint16_t>& triangles = picture.triangles_of(drawn, NodePicture::Skirt::without);
    const double in_a_place = static_cast<double>(triangles.size() / 3) / static_cast<double>(in_each);
    for (std::size_t i = 0; i < in_each; ++i) {
      const std::size_t first = chance.triangle_of(triangles);
      const ToldGround &a = vertices[triangles[first]], &b = vertices[triangles[first + 1]],
                       &c = vertices[triangles[first + 2]];
      const Corners corners = {a.place, b.place, c.place};
      const ToldGround told = between(a, b, c, chance.place_in_triangle());
      if (!seen.is_seen(told.place) || !turns_to(corners, pose.eye) || skyline.hides(told.place)) continue;
      const glm::dvec3 shown =
          shown_place(told, picture.terrain(), pose.eye, pixel_footprint(told.place, pose, footprint),
                      picture.needs().pixel_octaves_end);
      const double over = ground.over(shown), away = glm::distance(shown, pose.eye);
      // What lies so near before the place is the error of the place itself.
      const double before = away - 8.0 * std::abs(over) - 4.0 * ground.pixel_at(shown);
      errors.push_back({std::max(ground.seen_over(shown, over), ground.rises_before((shown - pose.eye) / away, before)),
                        std::abs(ground.over(told.place)) / ground.pixel_at(told.place),
                        in_a_place * pixels_of(corners, told.place, pose)});
    }
    skyline.add(places_of(vertices), triangles);
  }
  add_sky(picture, seen, skyline, ground, places, chance, errors);
  return errors;
}

}  // namespace terrella
