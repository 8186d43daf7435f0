#include "measure/beside_reference.hpp"

#include <algorithm>
#include <cmath>

#include "reference/tracer.hpp"

namespace terrella {
namespace {

constexpr int places = 48;

// Place i of a sequence that fills a square evenly (Roberts 2018, "The unreasonable effectiveness of quasirandom
// sequences").
glm::dvec2 even_place(int i) {
  return glm::fract(0.5 + static_cast<double>(i) * glm::dvec2(0.7548776662466927, 0.5698402909980532));
}

}  // namespace

BesideReference beside_reference(const Scene& scene, const View& view, Pixels light, Pixels distance) {
  const reference::Tracer tracer(scene, view);
  const double exposure = std::exp2(scene.picture.exposure);
  BesideReference beside;
  for (int i = 0; i < places; ++i) {
    const glm::dvec2 place = even_place(i);
    const int x = static_cast<int>(place.x * view.width), y = static_cast<int>(place.y * view.height);
    const reference::Sample sample = tracer.sample({x + 0.5, y + 0.5});
    const auto pixel = static_cast<std::size_t>(4 * ((view.height - 1 - y) * view.width + x));
    double off = 0.0, brightest = 0.0;
    for (int c = 0; c < 3; ++c) {
      const double drawn = double{light[pixel + static_cast<std::size_t>(c)]};
      const double is = std::clamp(sample.light[c] * exposure, 0.0, 1.0);
      off = std::max(off, std::abs(std::clamp(drawn, 0.0, 1.0) - is));
      brightest = std::max(brightest, is);
    }
    beside.brightness += brightest / places;
    beside.light += off / places;
    if (std::isinf(distance[pixel]) != std::isinf(sample.distance)) beside.silhouette += 1.0 / places;
  }
  return beside;
}

}  // namespace terrella
