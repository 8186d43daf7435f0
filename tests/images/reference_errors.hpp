// How far what is drawn lies from what the reference shows.
#pragma once

#include <cstdio>
#include <string>

#include "app/develop.hpp"
#include "app/still.hpp"
#include "effort.hpp"
#include "measure/flip.hpp"
#include "measure/image_error.hpp"
#include "reference/picture.hpp"

namespace terrella::test {

inline constexpr int errors_width = sanitized ? 24 : 160, errors_height = sanitized ? 14 : 90, errors_samples = 2;
inline constexpr double errors_seconds = 3.0;

struct Errors {
  double psnr = 0.0;  // dB, of linear light cut off at 1
  double flip = 0.0;  // mean, of the pictures as they are seen
  GeometryError geometry;
};

inline Image cut_off(Image light) {
  for (float& value : light.pixels) value = std::min(value, 1.0F);
  return light;
}

// Options: StillOptions or the reference's.
template <class Options>
Options asked_for(double seconds = errors_seconds) {
  Options options;
  options.width = errors_width;
  options.height = errors_height;
  options.seconds = seconds;
  options.samples = errors_samples;
  return options;
}

// What the reference shows of a scene.
struct Exact {
  explicit Exact(const Scene& scene)
      : light(reference::light(scene, asked_for<reference::Options>())),
        geometry(reference::geometry(scene, asked_for<reference::Options>())) {}
  Image light;
  reference::Geometry geometry;
};

inline Image light_of(const Scene& scene, Renderer& renderer) {
  return take_measurement(renderer, scene, asked_for<StillOptions>(), Channel::color);
}

inline Errors errors_of(const Scene& scene, Renderer& renderer, const Exact& exact) {
  const auto still = asked_for<StillOptions>();
  const Image drawn = light_of(scene, renderer);
  Errors errors;
  errors.psnr = psnr(cut_off(drawn), cut_off(exact.light));
  errors.flip = mean_of(flip(developed(exact.light, scene.picture.tone), developed(drawn, scene.picture.tone)));
  errors.geometry = geometry_error(take_measurement(renderer, scene, still, Channel::distance),
                                   take_measurement(renderer, scene, still, Channel::normal), exact.geometry.distance,
                                   exact.geometry.normal);
  return errors;
}

inline std::string text_of(const Errors& e) {
  char text[200];
  std::snprintf(text, sizeof text,
                "%.1f dB, flip %.4f, silhouette %.4f, distance %.1e (p99 %.1e), normal %.2f deg (p99 %.1f)", e.psnr,
                e.flip, e.geometry.silhouette, e.geometry.distance_median, e.geometry.distance_p99,
                e.geometry.normal_median, e.geometry.normal_p99);
  return text;
}

}  // namespace terrella::test
