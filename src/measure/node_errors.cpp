#include "measure/node_errors.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>

#include <glm/geometric.hpp>

#include "base/check.hpp"
#include "measure/node_rays.hpp"
#include "measure/seen_places.hpp"

namespace terrella {
namespace {

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

// Where a ray leaves the sphere of the highest mountains; nothing where it never meets that.
std::optional<double> leaves_mountains(const NodePicture& picture, const glm::dvec3& ray) {
  const glm::dvec3& eye = picture.pose().eye;
  const double highest = 1.0 + picture.terrain().height, middle = -glm::dot(eye, ray);
  const double half_square = highest * highest - glm::dot(eye, eye) + middle * middle;
  if (half_square <= 0.0 || middle + std::sqrt(half_square) <= 0.0) return std::nullopt;
  return middle + std::sqrt(half_square);
}

class Errors {
 public:
  Errors(const NodePicture& picture, double footprint)
      : picture_(picture),
        footprint_(footprint),
        seen_(picture.scene(), picture.view(), picture.pose(), picture.needs()),
        rays_(picture),
        ground_(picture, seen_, footprint) {}

  // Of what is shown at a place of the picture, pixels from its middle; nothing where that is no ground, nor is any
  // before it.
  [[nodiscard]] std::optional<NodeError> at(const glm::dvec2& pixel) const {
    const glm::dvec3 ray = seen_.ray_to(pixel);
    if (const std::optional<ToldGround> told = rays_.first_along(ray)) {
      return seen_.is_hidden(told->place) ? std::nullopt : std::optional(of_ground(*told, ray));
    }
    return of_sky(ray);
  }

 private:
  [[nodiscard]] NodeError of_ground(const ToldGround& told, const glm::dvec3& ray) const {
    const Pose& pose = picture_.pose();
    const glm::dvec3 shown = shown_place(told, picture_.terrain(), pose.eye, footprint_ * pose.pixel_angle,
                                         picture_.needs().pixel_octaves_end);
    const double over = ground_.over(shown), away = glm::distance(shown, pose.eye);
    // What lies so near before the place is the error of the place itself.
    const double before = away - 8.0 * std::abs(over) - 4.0 * ground_.pixel_at(shown);
    return {std::max(ground_.seen_over(shown, over), ground_.rises_before(ray, before)),
            std::abs(ground_.over(told.place)) / ground_.pixel_at(told.place)};
  }

  [[nodiscard]] std::optional<NodeError> of_sky(const glm::dvec3& ray) const {
    const std::optional<double> leaves = leaves_mountains(picture_, ray);
    if (!leaves || seen_.is_hidden(picture_.pose().eye + *leaves * ray)) return std::nullopt;
    const double off = ground_.rises_before(ray, *leaves);
    return off > 0.0 ? std::optional(NodeError{off, off}) : std::nullopt;
  }

  const NodePicture& picture_;
  double footprint_;
  SeenPlaces seen_;
  NodeRays rays_;
  TrueGround ground_;
};

}  // namespace

double percentile(const std::vector<NodeError>& errors, double NodeError::*of, double part) {
  CHECK(!errors.empty());
  std::vector<double> values;
  for (const NodeError& error : errors) values.push_back(error.*of);
  const auto count = static_cast<std::ptrdiff_t>(std::ceil(part * static_cast<double>(values.size())));
  const auto at = values.begin() + std::max<std::ptrdiff_t>(count - 1, 0);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

std::vector<NodeError> node_errors(const NodePicture& picture, int places, double footprint) {
  constexpr int most_tried = 16;  // for each place of ground
  const Errors errors_of(picture, footprint);
  const glm::dvec2 size(picture.view().width, picture.view().height);
  std::mt19937 random{3U};
  const auto part = [&] { return static_cast<double>(random()) / 4294967296.0; };
  std::vector<NodeError> errors;
  for (int i = 0; i < most_tried * places && std::ssize(errors) < places; ++i) {
    const double x = part(), y = part();
    if (const std::optional<NodeError> error = errors_of.at((glm::dvec2(x, y) - 0.5) * size)) errors.push_back(*error);
  }
  return errors;
}

}  // namespace terrella
