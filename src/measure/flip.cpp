#include "measure/flip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>

#include "base/check.hpp"
#include "measure/cie.hpp"

namespace terrella {
namespace {

// One channel of a picture in double precision. Beyond its edges it goes on as at them.
struct Plane {
  int width, height;
  std::vector<double> values;

  [[nodiscard]] const double* row(int y) const {
    return values.data() + static_cast<std::size_t>(std::clamp(y, 0, height - 1)) * static_cast<std::size_t>(width);
  }
};

glm::dvec3 rgb_of(const glm::dvec3& relative) {
  const glm::dvec3 c = relative * glm::dvec3(0.9504285453, 1.0, 1.0889003708);
  return {3.2410033 * c.x - 1.5373992 * c.y - 0.4986159 * c.z, -0.9692243 * c.x + 1.8759300 * c.y + 0.0415542 * c.z,
          0.0556394 * c.x - 0.2040112 * c.y + 1.0571490 * c.z};
}

// Achromatic, red to green, blue to yellow: linear in light.
glm::dvec3 opponent_of(const glm::dvec3& xyz) {
  return {116.0 * xyz.y - 16.0, 500.0 * (xyz.x - xyz.y), 200.0 * (xyz.y - xyz.z)};
}

glm::dvec3 xyz_of_opponent(const glm::dvec3& c) {
  const double y = (c.x + 16.0) / 116.0;
  return {y + c.y / 500.0, y, y - c.z / 200.0};
}

// CIE L*a*b*, with colours that fade in the dark (the Hunt effect).
glm::dvec3 seen_lab_of(const glm::dvec3& xyz) {
  const glm::dvec3 lab = lab_of(xyz);
  return {lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z};
}

// A distance for large differences of colour (Abasi et al. 2020).
double hyab(const glm::dvec3& a, const glm::dvec3& b) { return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z); }

using Kernel = std::vector<double>;  // of an odd length

Plane convolved_across(const Plane& from, const Kernel& kernel) {
  const std::size_t reach = kernel.size() / 2, width = static_cast<std::size_t>(from.width);
  Plane to = {from.width, from.height, {}};
  to.values.reserve(from.values.size());
  std::vector<double> row(width + 2 * reach);
  for (int y = 0; y < from.height; ++y) {
    const double* const pixels = from.row(y);
    std::fill_n(row.begin(), reach, pixels[0]);
    std::copy_n(pixels, width, row.begin() + static_cast<std::ptrdiff_t>(reach));
    std::fill_n(row.begin() + static_cast<std::ptrdiff_t>(reach + width), reach, pixels[width - 1]);
    for (std::size_t x = 0; x < width; ++x) {
      double sum = 0.0;
      for (std::size_t i = 0; i < kernel.size(); ++i) sum += kernel[i] * row[x + i];
      to.values.push_back(sum);
    }
  }
  return to;
}

Plane convolved_down(const Plane& from, const Kernel& kernel) {
  const int reach = static_cast<int>(kernel.size()) / 2;
  Plane to = {from.width, from.height, std::vector<double>(from.values.size(), 0.0)};
  double* sums = to.values.data();
  for (int y = 0; y < from.height; ++y, sums += from.width) {
    for (int i = -reach; i <= reach; ++i) {
      const double* const pixels = from.row(y + i);
      const double weight = kernel[static_cast<std::size_t>(i + reach)];
      for (int x = 0; x < from.width; ++x) sums[x] += weight * pixels[x];
    }
  }
  return to;
}

Plane convolved(const Plane& from, const Kernel& across, const Kernel& down) {
  return convolved_down(convolved_across(from, across), down);
}

// The eye's contrast sensitivity by channel as sums of two Gaussians a sqrt(pi / b) exp(-pi^2 d^2 / b), d in degrees.
struct Sensitivity {
  double a1, b1, a2, b2;
};
constexpr Sensitivity sensitivities[] = {{1.0, 0.0047, 0.0, 1e-5}, {1.0, 0.0053, 0.0, 1e-5}, {34.1, 0.04, 13.5, 0.025}};

Kernel gaussian(double b, double pixels_per_degree, int reach) {
  Kernel kernel;
  for (int i = -reach; i <= reach; ++i) {
    const double degrees = i / pixels_per_degree;
    kernel.push_back(std::exp(-std::numbers::pi * std::numbers::pi * degrees * degrees / b));
  }
  return kernel;
}

double sum_of(const Kernel& kernel) {
  double sum = 0.0;
  for (const double k : kernel) sum += k;
  return sum;
}

// As the eye sees a channel (0..2) of a picture in opponent colours from afar.
Plane seen(const Plane& picture, int channel, double pixels_per_degree) {
  constexpr double widest = 0.04;
  const int reach = static_cast<int>(
      std::ceil(3.0 * std::sqrt(widest / (2.0 * std::numbers::pi * std::numbers::pi)) * pixels_per_degree));
  const auto [a1, b1, a2, b2] = sensitivities[channel];
  double total = 0.0;
  Plane sum = {picture.width, picture.height, std::vector<double>(picture.values.size(), 0.0)};
  for (const auto& [a, b] : {std::pair{a1, b1}, std::pair{a2, b2}}) {
    if (a == 0.0) continue;
    const Kernel kernel = gaussian(b, pixels_per_degree, reach);
    const double weight = a * std::sqrt(std::numbers::pi / b);
    total += weight * sum_of(kernel) * sum_of(kernel);
    const Plane blurred = convolved(picture, kernel, kernel);
    for (std::size_t i = 0; i < sum.values.size(); ++i) sum.values[i] += weight * blurred.values[i];
  }
  for (double& value : sum.values) value /= total;
  return sum;
}

glm::dvec3 clamped(const glm::dvec3& c) {
  return {std::clamp(c.r, 0.0, 1.0), std::clamp(c.g, 0.0, 1.0), std::clamp(c.b, 0.0, 1.0)};
}

// Differences of colour, spread over 0..1: small ones over most of it.
double redistributed(double difference) {
  constexpr double exponent = 0.7, bend = 0.4, bent = 0.95;
  static const double most =
      std::pow(hyab(seen_lab_of(xyz_of({0.0, 1.0, 0.0})), seen_lab_of(xyz_of({0.0, 0.0, 1.0}))), exponent);
  const double d = std::pow(difference, exponent), at = bend * most;
  return d < at ? bent / at * d : bent + (d - at) / (most - at) * (1.0 - bent);
}

// The positive weights sum to 1, the negative ones to -1.
Kernel balanced(Kernel kernel) {
  double up = 0.0, down = 0.0;
  for (const double k : kernel) (k > 0.0 ? up : down) += std::abs(k);
  for (double& k : kernel) k /= k > 0.0 ? up : down > 0.0 ? down : 1.0;
  return kernel;
}

// How strongly edges (x) and points (y) are seen at each pixel of lightness.
std::vector<glm::dvec2> features(const Plane& lightness, double pixels_per_degree) {
  constexpr double width = 0.082;  // degrees
  const double deviation = 0.5 * width * pixels_per_degree;
  const int reach = static_cast<int>(std::ceil(3.0 * deviation));
  Kernel smooth, edge, point;
  for (int i = -reach; i <= reach; ++i) {
    const double x = i / deviation, g = std::exp(-0.5 * x * x);
    smooth.push_back(g);
    edge.push_back(-x * g);
    point.push_back((x * x - 1.0) * g);
  }
  const double whole = sum_of(smooth);
  for (double& k : smooth) k /= whole;
  const Plane edge_x = convolved(lightness, balanced(edge), smooth),
              edge_y = convolved(lightness, smooth, balanced(edge));
  const Plane point_x = convolved(lightness, balanced(point), smooth),
              point_y = convolved(lightness, smooth, balanced(point));
  std::vector<glm::dvec2> found;
  for (std::size_t i = 0; i < lightness.values.size(); ++i) {
    found.emplace_back(std::hypot(edge_x.values[i], edge_y.values[i]),
                       std::hypot(point_x.values[i], point_y.values[i]));
  }
  return found;
}

// Its channels in opponent colours.
std::array<Plane, 3> opponent_planes(const Image& image) {
  std::array<Plane, 3> planes;
  planes.fill({image.width, image.height, {}});
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    const glm::dvec3 linear(linear_of_srgb(double{image.pixels[i]}), linear_of_srgb(double{image.pixels[i + 1]}),
                            linear_of_srgb(double{image.pixels[i + 2]}));
    const glm::dvec3 opponent = opponent_of(xyz_of(linear));
    for (int c = 0; c < 3; ++c) planes[static_cast<std::size_t>(c)].values.push_back(opponent[c]);
  }
  return planes;
}

}  // namespace

Flip::Looked Flip::look_at(const Image& image) const {
  CHECK(image.channels == 3, "pictures of three channels");
  std::array<Plane, 3> planes = opponent_planes(image);
  Looked looked;
  const std::array<Plane, 3> far = {seen(planes[0], 0, pixels_per_degree_), seen(planes[1], 1, pixels_per_degree_),
                                    seen(planes[2], 2, pixels_per_degree_)};
  for (std::size_t i = 0; i < far[0].values.size(); ++i) {
    const glm::dvec3 opponent(far[0].values[i], far[1].values[i], far[2].values[i]);
    looked.colors.push_back(seen_lab_of(xyz_of(clamped(rgb_of(xyz_of_opponent(opponent))))));
  }
  for (double& value : planes[0].values) value = (value + 16.0) / 116.0;
  looked.features = features(planes[0], pixels_per_degree_);
  return looked;
}

Flip::Flip(const Image& reference, double pixels_per_degree)
    : width_(reference.width),
      height_(reference.height),
      pixels_per_degree_(pixels_per_degree),
      reference_(look_at(reference)) {}

Image Flip::against(const Image& test) const {
  CHECK(test.width == width_ && test.height == height_, "pictures of one size");
  const Looked looked = look_at(test);
  Image errors(width_, height_, 1);
  for (std::size_t i = 0; i < errors.pixels.size(); ++i) {
    const double color = redistributed(hyab(reference_.colors[i], looked.colors[i]));
    const glm::dvec2 apart = glm::abs(reference_.features[i] - looked.features[i]);
    const double feature = std::sqrt(std::max(apart.x, apart.y) * std::numbers::sqrt2 * 0.5);
    errors.pixels[i] = static_cast<float>(std::pow(color, 1.0 - std::min(feature, 1.0)));
  }
  return errors;
}

Image flip(const Image& reference, const Image& test, double pixels_per_degree) {
  return Flip(reference, pixels_per_degree).against(test);
}

}  // namespace terrella
