#include "app/still.hpp"

#include <algorithm>

#include "app/develop.hpp"
#include "gl/caps.hpp"
#include "gl/target.hpp"

namespace terrella {
namespace {

// A part of a picture, in its pixels, from the top left.
struct Tile {
  int x, y, width, height;
};

Tile all_of(const StillOptions& options) { return {0, 0, options.width, options.height}; }

View view_of(const StillOptions& options, const Tile& tile) {
  View view;
  view.width = tile.width;
  view.height = tile.height;
  view.seconds = options.seconds;
  view.field = options.field * tile.height / options.height;
  view.whole = {options.width, options.height, options.field};
  view.shift = 0.5 * glm::dvec2(options.width, options.height) -
               (glm::dvec2(tile.x, tile.y) + 0.5 * glm::dvec2(tile.width, tile.height));
  return view;
}

// The mean of the light of all samples, top row first. channels: 3, or 4 with the part of the sky that is covered.
Image mean_light(Renderer& renderer, const Scene& scene, const StillOptions& options, const Tile& tile, int channels) {
  Image mean(tile.width, tile.height, channels);
  View view = view_of(options, tile);
  const glm::dvec2 shift = view.shift;
  const int n = options.samples;
  const float share = 1.0F / static_cast<float>(n * n);
  for (int sample = 0; sample < n * n; ++sample) {
    view.shift = shift + glm::dvec2((sample % n + 0.5) / n - 0.5, (sample / n + 0.5) / n - 0.5);
    renderer.draw(scene, view, {Channel::color, Effort::complete, true});
    const std::vector<float> light = renderer.read_light();
    for (int y = 0; y < tile.height; ++y) {
      const float* from = light.data() + std::size_t{4} * static_cast<std::size_t>(tile.height - 1 - y) *
                                             static_cast<std::size_t>(tile.width);
      for (int x = 0; x < tile.width; ++x) {
        for (int c = 0; c < channels; ++c) mean.at(x, y)[c] += share * from[4 * x + c];
      }
    }
  }
  return mean;
}

// The planet alone. Its edges are as smooth as there are samples.
Image cut_out(Renderer& renderer, Scene scene, StillOptions options, const Tile& tile) {
  scene.stars.density = scene.sun.size = scene.sun.glare = 0.0;
  options.samples = std::max(2, options.samples);
  return developed(mean_light(renderer, scene, options, tile, 4), scene.picture.tone);
}

// As the window shows it.
Image shown(Renderer& renderer, const Scene& scene, const StillOptions& options, const Tile& tile) {
  const View view = drawn_at(view_of(options, tile), scene.quality.resolution_scale, gl::caps().max_texture);
  renderer.draw(scene, view, {});
  const gl::Target target(tile.width, tile.height, gl::Format::rgba8, gl::Depth::none);
  target.begin();
  renderer.show({target.framebuffer(), tile.width, tile.height}, scene.quality.antialias);
  const std::vector<unsigned char> bytes = target.read_bytes();
  Image picture(tile.width, tile.height, 3);
  for (int y = 0; y < tile.height; ++y) {
    const unsigned char* from = bytes.data() + std::size_t{4} * static_cast<std::size_t>(tile.height - 1 - y) *
                                                   static_cast<std::size_t>(tile.width);
    for (int x = 0; x < tile.width; ++x) {
      for (int c = 0; c < 3; ++c) picture.at(x, y)[c] = static_cast<float>(from[4 * x + c]) / 255.0F;
    }
  }
  return picture;
}

Image take_tile(Renderer& renderer, const Scene& scene, const StillOptions& options, const Tile& tile) {
  if (options.transparent) return cut_out(renderer, scene, options, tile);
  if (options.samples > 1) return developed(mean_light(renderer, scene, options, tile, 3), scene.picture.tone);
  return shown(renderer, scene, options, tile);
}

// Where a part of the picture begins and ends along one side, with as much around it as smoothing looks at.
struct Span {
  int first, last;    // of what is kept
  int begin, length;  // of what is drawn
};

std::vector<Span> spans(int size, int largest) {
  constexpr int around = 8;
  if (size <= largest) return {{0, size, 0, size}};
  std::vector<Span> all;
  const int step = std::max(1, largest - 2 * around);
  for (int first = 0; first < size; first += step) {
    const int last = std::min(size, first + step);
    const int begin = std::max(0, first - around), end = std::min(size, last + around);
    all.push_back({first, last, begin, end - begin});
  }
  return all;
}

}  // namespace

Image take_picture(Renderer& renderer, const Scene& scene, const StillOptions& options) {
  Image picture(options.width, options.height, options.transparent ? 4 : 3);
  // Where more pixels are drawn than are shown, of smaller parts.
  const int largest = static_cast<int>(options.largest_tile / std::max(1.0, scene.quality.resolution_scale));
  for (const Span& rows : spans(options.height, largest)) {
    for (const Span& columns : spans(options.width, largest)) {
      const Image tile = take_tile(renderer, scene, options, {columns.begin, rows.begin, columns.length, rows.length});
      for (int y = rows.first; y < rows.last; ++y) {
        const float* from = tile.at(columns.first - columns.begin, y - rows.begin);
        std::copy_n(from, (columns.last - columns.first) * picture.channels, picture.at(columns.first, y));
      }
    }
  }
  return picture;
}

Image take_measurement(Renderer& renderer, const Scene& scene, const StillOptions& options, Channel channel) {
  if (channel == Channel::color) return mean_light(renderer, scene, options, all_of(options), 3);
  renderer.draw(scene, view_of(options, all_of(options)), {channel, Effort::complete, true});
  const std::vector<float> values = renderer.read_light();
  const int channels = channel == Channel::normal ? 3 : 1;
  // The GPU measures in planet radii.
  const double unit = channel == Channel::normal ? 1.0 : scene.planet.radius;
  Image image(options.width, options.height, channels);
  for (int y = 0; y < options.height; ++y) {
    const float* from = values.data() + std::size_t{4} * static_cast<std::size_t>(options.height - 1 - y) *
                                            static_cast<std::size_t>(options.width);
    for (int x = 0; x < options.width; ++x) {
      for (int c = 0; c < channels; ++c) image.at(x, y)[c] = static_cast<float>(unit * double{from[4 * x + c]});
    }
  }
  return image;
}

}  // namespace terrella
