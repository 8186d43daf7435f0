#include "measure/beside_reference.hpp"

#include <algorithm>
#include <cmath>

#include "reference/tracer.hpp"

namespace terrella {
namespace {

constexpr int places_compared = 48;

// Place i of a sequence that fills a square evenly (Roberts 2018, "The unreasonable effectiveness of quasirandom
// sequences").
glm::dvec2 even_place(int i) {
  return glm::fract(0.5 + static_cast<double>(i) * glm::dvec2(0.7548776662466927, 0.5698402909980532));
}

// What is left out are layers that no pixel of the picture can show, as the renderer leaves them out: single samples
// would show them as noise.
reference::Footprints of_pixels(const Pose& pose) {
  const double pixel = pose.pixel_angle * pose.nearest;
  return {pixel, pixel, pixel};
}

// The mean light of a pixel, held to 0..1.
glm::dvec3 light_of_pixel(const reference::Tracer& tracer, const glm::dvec2& corner, double exposure) {
  constexpr int samples = 2;  // along each side
  glm::dvec3 sum(0.0);
  for (int i = 0; i < samples * samples; ++i) {
    const glm::dvec2 within((i % samples + 0.5) / samples, (i / samples + 0.5) / samples);
    sum += tracer.sample(corner + within).light;
  }
  return glm::clamp(sum * exposure / double{samples * samples}, 0.0, 1.0);
}

}  // namespace

void make_comparable(Scene& scene) {
  auto& quality = scene.quality;
  quality.pixel_error = std::min(quality.pixel_error, 0.2);
  quality.finest_layer = std::min(quality.finest_layer, 8.0);
  quality.ground_texels = std::max(quality.ground_texels, 256);
  quality.cloud_texels = std::max(quality.cloud_texels, 128);
}

BesideReference beside_reference(const Scene& scene, const View& view, Pixels light, Pixels distance) {
  const reference::Tracer tracer(scene, view, of_pixels(pose_of(scene, view)));
  const double exposure = std::exp2(scene.picture.exposure);
  BesideReference beside;
  for (int i = 0; i < places_compared; ++i) {
    const glm::dvec2 place = even_place(i);
    const int x = static_cast<int>(place.x * view.width), y = static_cast<int>(place.y * view.height);
    const glm::dvec3 is = light_of_pixel(tracer, {x, y}, exposure);
    const auto pixel = static_cast<std::size_t>(4 * ((view.height - 1 - y) * view.width + x));
    double off = 0.0, brightest = 0.0;
    for (int c = 0; c < 3; ++c) {
      const double drawn = double{light[pixel + static_cast<std::size_t>(c)]};
      off = std::max(off, std::abs(std::clamp(drawn, 0.0, 1.0) - is[c]));
      brightest = std::max(brightest, is[c]);
    }
    beside.brightness += brightest / places_compared;
    beside.light += off / places_compared;
    const bool sky = std::isinf(tracer.geometry({x + 0.5, y + 0.5}).distance);
    if (std::isinf(distance[pixel]) != sky) beside.silhouette += 1.0 / places_compared;
  }
  return beside;
}

}  // namespace terrella
