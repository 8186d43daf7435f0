#include "measure/image_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

#include "base/check.hpp"
#include "formulas/formulas.hpp"
#include "measure/cie.hpp"

namespace terrella {
namespace {

// The value that a share of the values does not pass; 0 of none.
double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  const auto at = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
  return values[at];
}

glm::dvec3 vector_at(const Image& image, std::size_t pixel) {
  return {image.pixels[3 * pixel], image.pixels[3 * pixel + 1], image.pixels[3 * pixel + 2]};
}

// A pixel's colour in L*a*b*.
glm::dvec3 seen_at(const Image& image, std::size_t pixel) {
  const glm::dvec3 c = vector_at(image, pixel);
  return lab_of(xyz_of({linear_of_srgb(c.r), linear_of_srgb(c.g), linear_of_srgb(c.b)}));
}

}  // namespace

double mean_square_error(const Image& a, const Image& b) {
  CHECK(a.pixels.size() == b.pixels.size(), "pictures of one size");
  double squares = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const double d = double{a.pixels[i]} - double{b.pixels[i]};
    squares += d * d;
  }
  return squares / static_cast<double>(a.pixels.size());
}

double psnr_of(double mean_square) { return mean_square == 0.0 ? 200.0 : -10.0 * std::log10(mean_square); }

double psnr(const Image& a, const Image& b) { return psnr_of(mean_square_error(a, b)); }

double visible_share(const Image& a, const Image& b) {
  CHECK(a.channels == 3 && b.channels == 3 && a.pixels.size() == b.pixels.size(), "pictures of one size");
  constexpr double just_noticeable = 2.3;
  const std::size_t count = a.pixels.size() / 3;
  std::size_t visible = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (glm::distance(seen_at(a, i), seen_at(b, i)) > just_noticeable) ++visible;
  }
  return static_cast<double>(visible) / static_cast<double>(count);
}

double mean_of(const Image& image) {
  double sum = 0.0;
  for (const float value : image.pixels) sum += double{value};
  return sum / static_cast<double>(image.pixels.size());
}

double quantile_of(const Image& image, double share) {
  return quantile({image.pixels.begin(), image.pixels.end()}, share);
}

GeometryError geometry_error(const Image& distance, const Image& normal, const Image& true_distance,
                             const Image& true_normal) {
  const std::size_t count = true_distance.pixels.size();
  CHECK(distance.pixels.size() == count && normal.pixels.size() == 3 * count && true_normal.pixels.size() == 3 * count,
        "pictures of one size");
  std::size_t one_alone = 0;
  std::vector<double> distances, angles;
  for (std::size_t i = 0; i < count; ++i) {
    const double seen = double{distance.pixels[i]}, is = double{true_distance.pixels[i]};
    if (std::isinf(seen) != std::isinf(is)) ++one_alone;
    if (std::isinf(seen) || std::isinf(is)) continue;
    distances.push_back(std::abs(seen - is) / is);
    const glm::dvec3 a = vector_at(normal, i), b = vector_at(true_normal, i);
    angles.push_back(glm::degrees(f64::angle_between(a, b)));
  }
  GeometryError error;
  error.silhouette = static_cast<double>(one_alone) / static_cast<double>(count);
  error.distance_median = quantile(distances, 0.5);
  error.distance_p99 = quantile(std::move(distances), 0.99);
  error.normal_median = quantile(angles, 0.5);
  error.normal_p99 = quantile(std::move(angles), 0.99);
  return error;
}

double outline_length(const Image& distance) {
  std::int64_t crossings = 0;
  const auto differ = [&](int x, int y, int u, int v) {
    return std::isinf(*distance.at(x, y)) != std::isinf(*distance.at(u, v));
  };
  for (int y = 0; y < distance.height; ++y) {
    for (int x = 0; x < distance.width; ++x) {
      if (x + 1 < distance.width && differ(x, y, x + 1, y)) ++crossings;
      if (y + 1 < distance.height && differ(x, y, x, y + 1)) ++crossings;
    }
  }
  return 0.25 * std::numbers::pi * static_cast<double>(crossings);
}

}  // namespace terrella
