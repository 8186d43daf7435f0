#include "reference/picture.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>
#include <vector>

#include "reference/tracer.hpp"

namespace terrella::reference {
namespace {

View view_of(const Options& options) {
  View view;
  view.width = options.width;
  view.height = options.height;
  view.seconds = options.seconds;
  return view;
}

// Calls draw_row for each row, on several threads. Rows are handed out one by one: some take much longer than others.
void for_rows(const Options& options, const std::function<void(int)>& draw_row) {
  std::atomic<int> next = 0, done = 0;
  const auto work = [&] {
    for (int row = next++; row < options.height; row = next++) {
      draw_row(row);
      ++done;
    }
  };
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::thread> threads(options.threads > 0 ? static_cast<unsigned>(options.threads) : cores);
  for (std::thread& thread : threads) thread = std::thread(work);
  while (options.progress && done < options.height) {
    options.progress(static_cast<double>(done) / options.height);
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  }
  for (std::thread& thread : threads) thread.join();
  if (options.progress) options.progress(1.0);
}

void put(Image& image, int x, int y, const glm::dvec3& value) {
  for (int c = 0; c < 3; ++c) image.at(x, y)[c] = static_cast<float>(value[c]);
}

}  // namespace

Image light(const Scene& scene, const Options& options) {
  const Tracer tracer(scene, view_of(options), options.left_out);
  const double exposure = std::exp2(scene.picture.exposure);
  const int n = options.samples;
  Image image(options.width, options.height, 3);
  for_rows(options, [&](int y) {
    for (int x = 0; x < options.width; ++x) {
      glm::dvec3 sum(0.0);
      for (int i = 0; i < n * n; ++i) sum += tracer.sample({x + (i % n + 0.5) / n, y + (i / n + 0.5) / n}).light;
      put(image, x, y, sum * (exposure / (n * n)));
    }
  });
  return image;
}

Geometry geometry(const Scene& scene, const Options& options) {
  const Tracer tracer(scene, view_of(options), options.left_out);
  const double radius = scene.planet.radius;
  Geometry geometry = {Image(options.width, options.height, 1), Image(options.width, options.height, 3),
                       Image(options.width, options.height, 1)};
  for_rows(options, [&](int y) {
    for (int x = 0; x < options.width; ++x) {
      const Sample sample = tracer.geometry({x + 0.5, y + 0.5});
      *geometry.distance.at(x, y) = static_cast<float>(sample.distance * radius);
      *geometry.height.at(x, y) = static_cast<float>(sample.height * radius);
      put(geometry.normal, x, y, sample.normal);
    }
  });
  return geometry;
}

}  // namespace terrella::reference
