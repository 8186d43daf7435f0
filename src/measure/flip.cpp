#include "measure/flip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/check.hpp"

namespace terrella {
namespace {

// A picture in double precision.
struct Plane {
  int width, height;
  std::vector<glm::dvec3> pixels;

  // Beyond its edges it goes on as at them.
  [[nodiscard]] const glm::dvec3& at(int x, int y) const {
    x = std::clamp(x, 0, width - 1);
    y = std::clamp(y, 0, height - 1);
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
};

Plane mapped(const Plane& from, const std::function<glm::dvec3(const glm::dvec3&)>& f) {
  Plane to = from;
  for (glm::dvec3& pixel : to.pixels) pixel = f(pixel);
  return to;
}

Plane plane_of(const Image& image) {
  Plane plane = {image.width, image.height, {}};
  for (std::size_t i = 0; i < image.pixels.size(); i += 3)
    plane.pixels.emplace_back(image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]);
  return plane;
}

// The exact curve: the picture's own (lib/color.glsl) is fitted within 4e-5.
double linear_of_srgb(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

// CIE XYZ of the sRGB primaries under D65, relative to white.
glm::dvec3 xyz_of(const glm::dvec3& c) {
  const glm::dvec3 xyz(0.4123865632 * c.r + 0.3575914909 * c.g + 0.1804504912 * c.b,
                       0.2126368217 * c.r + 0.7151829818 * c.g + 0.0721801965 * c.b,
                       0.0193306202 * c.r + 0.1191971636 * c.g + 0.9503725870 * c.b);
  return xyz / glm::dvec3(0.9504285453, 1.0, 1.0889003708);
}

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
glm::dvec3 lab_of(const glm::dvec3& xyz) {
  constexpr double limit = 6.0 / 29.0;
  const auto f = [](double t) {
    return t > limit * limit * limit ? std::cbrt(t) : t / (3.0 * limit * limit) + 4.0 / 29.0;
  };
  const double lightness = 116.0 * f(xyz.y) - 16.0;
  const double hunt = 0.01 * lightness;
  return {lightness, hunt * 500.0 * (f(xyz.x) - f(xyz.y)), hunt * 200.0 * (f(xyz.y) - f(xyz.z))};
}

// A distance for large differences of colour (Abasi et al. 2020).
double hyab(const glm::dvec3& a, const glm::dvec3& b) { return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z); }

using Kernel = std::vector<double>;  // of an odd length

Plane convolved(const Plane& from, const Kernel& across, const Kernel& down) {
  const auto pass = [](const Plane& plane, const Kernel& kernel, int dx, int dy) {
    Plane to = plane;
    const int reach = static_cast<int>(kernel.size()) / 2;
    for (int y = 0; y < plane.height; ++y) {
      for (int x = 0; x < plane.width; ++x) {
        glm::dvec3 sum(0.0);
        for (int i = -reach; i <= reach; ++i)
          sum += kernel[static_cast<std::size_t>(i + reach)] * plane.at(x + i * dx, y + i * dy);
        to.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(plane.width) + static_cast<std::size_t>(x)] =
            sum;
      }
    }
    return to;
  };
  return pass(pass(from, across, 1, 0), down, 0, 1);
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

// As the eye sees a picture in opponent colours from afar.
Plane seen(const Plane& picture, double pixels_per_degree) {
  constexpr double widest = 0.04;
  const int reach = static_cast<int>(
      std::ceil(3.0 * std::sqrt(widest / (2.0 * std::numbers::pi * std::numbers::pi)) * pixels_per_degree));
  Plane result = picture;
  for (int channel = 0; channel < 3; ++channel) {
    const auto [a1, b1, a2, b2] = sensitivities[channel];
    double total = 0.0;
    std::vector<double> sum(picture.pixels.size(), 0.0);
    for (const auto& [a, b] : {std::pair{a1, b1}, std::pair{a2, b2}}) {
      if (a == 0.0) continue;
      const Kernel kernel = gaussian(b, pixels_per_degree, reach);
      const double weight = a * std::sqrt(std::numbers::pi / b);
      total += weight * sum_of(kernel) * sum_of(kernel);
      const Plane blurred = convolved(picture, kernel, kernel);
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += weight * blurred.pixels[i][channel];
    }
    for (std::size_t i = 0; i < sum.size(); ++i) result.pixels[i][channel] = sum[i] / total;
  }
  return result;
}

glm::dvec3 clamped(const glm::dvec3& c) {
  return {std::clamp(c.r, 0.0, 1.0), std::clamp(c.g, 0.0, 1.0), std::clamp(c.b, 0.0, 1.0)};
}

// Differences of colour, spread over 0..1: small ones over most of it.
double redistributed(double difference) {
  constexpr double exponent = 0.7, bend = 0.4, bent = 0.95;
  static const double most = std::pow(hyab(lab_of(xyz_of({0.0, 1.0, 0.0})), lab_of(xyz_of({0.0, 0.0, 1.0}))), exponent);
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
  for (std::size_t i = 0; i < lightness.pixels.size(); ++i) {
    found.emplace_back(std::hypot(edge_x.pixels[i].x, edge_y.pixels[i].x),
                       std::hypot(point_x.pixels[i].x, point_y.pixels[i].x));
  }
  return found;
}

struct Looked {
  Plane colors;                      // L*a*b* as seen
  std::vector<glm::dvec2> features;  // of the picture itself
};

Looked look_at(const Image& image, double pixels_per_degree) {
  const Plane opponent = mapped(plane_of(image), [](const glm::dvec3& c) {
    return opponent_of(xyz_of({linear_of_srgb(c.r), linear_of_srgb(c.g), linear_of_srgb(c.b)}));
  });
  Looked looked;
  looked.colors = mapped(seen(opponent, pixels_per_degree),
                         [](const glm::dvec3& c) { return lab_of(xyz_of(clamped(rgb_of(xyz_of_opponent(c))))); });
  looked.features = features(mapped(opponent, [](const glm::dvec3& c) { return glm::dvec3((c.x + 16.0) / 116.0); }),
                             pixels_per_degree);
  return looked;
}

}  // namespace

Image flip(const Image& reference, const Image& test, double pixels_per_degree) {
  CHECK(reference.width == test.width && reference.height == test.height, "pictures of one size");
  CHECK(reference.channels == 3 && test.channels == 3, "pictures of three channels");
  const Looked a = look_at(reference, pixels_per_degree), b = look_at(test, pixels_per_degree);
  Image errors(reference.width, reference.height, 1);
  for (std::size_t i = 0; i < errors.pixels.size(); ++i) {
    const double color = redistributed(hyab(a.colors.pixels[i], b.colors.pixels[i]));
    const glm::dvec2 apart = glm::abs(a.features[i] - b.features[i]);
    const double feature = std::sqrt(std::max(apart.x, apart.y) * std::numbers::sqrt2 * 0.5);
    errors.pixels[i] = static_cast<float>(std::pow(color, 1.0 - std::min(feature, 1.0)));
  }
  return errors;
}

}  // namespace terrella
