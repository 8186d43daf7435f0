#include "measure/stability.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include <glm/trigonometric.hpp>

#include "base/check.hpp"

namespace terrella {
namespace {

constexpr double step = 1e-3;      // pixels that the camera moves
constexpr double bound = 1e-2;     // pixels that a measurement must be able to tell
constexpr double rounding = 4e-7;  // of a value computed in single precision, as a part of it

std::vector<float> draw(Renderer& renderer, const Scene& scene, const View& view, Channel channel) {
  renderer.draw(scene, view, {channel, Effort::complete, true});
  return renderer.read_light();
}

// A channel's values at a pixel and its neighbours.
class ChannelField {
 public:
  ChannelField(Pixels pixels, int width, int channels) : pixels_(pixels), width_(width), channels_(channels) {}

  [[nodiscard]] double apart(int x, int y, int u, int v) const {
    double squares = 0.0;
    for (int c = 0; c < channels_; ++c) squares += std::pow(at(x, y, c) - at(u, v, c), 2);
    return std::sqrt(squares);
  }
  // By how much the value in the middle differs from the mean of two neighbours.
  [[nodiscard]] double bend(int x, int y, int dx, int dy) const {
    double squares = 0.0;
    for (int c = 0; c < channels_; ++c) {
      squares += std::pow(at(x, y, c) - 0.5 * (at(x + dx, y + dy, c) + at(x - dx, y - dy, c)), 2);
    }
    return std::sqrt(squares);
  }
  [[nodiscard]] double size(int x, int y) const {
    double squares = 0.0;
    for (int c = 0; c < channels_; ++c) squares += at(x, y, c) * at(x, y, c);
    return std::sqrt(squares);
  }
  [[nodiscard]] double at(int x, int y, int c) const {
    return pixels_[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)) +
                   static_cast<std::size_t>(c)];
  }

 private:
  Pixels pixels_;
  int width_, channels_;
};

bool is_planet(const ChannelField& field, int x, int y) {
  const double size = field.size(x, y);
  return std::isfinite(size) && size > 0.0;
}

// How much a channel changes from pixel to pixel; 0 where it jumps or ends.
double slope_at(const ChannelField& field, int x, int y) {
  for (const auto& [dx, dy] : {std::array{1, 0}, std::array{-1, 0}, std::array{0, 1}, std::array{0, -1}}) {
    if (!is_planet(field, x + dx, y + dy)) return 0.0;
  }
  const double across = 0.5 * field.apart(x - 1, y, x + 1, y), along = 0.5 * field.apart(x, y - 1, x, y + 1);
  const double bend = field.bend(x, y, 1, 0) + field.bend(x, y, 0, 1);
  const double slope = std::hypot(across, along);
  return bend < 0.5 * slope ? slope : 0.0;
}

// The scene with its camera moved along the surface, rad.
Scene moved(Scene scene, double angle) {
  auto& camera = scene.camera;
  const double degrees = glm::degrees(angle);
  if (std::abs(camera.latitude) < 80.0) {
    camera.longitude += degrees / std::cos(glm::radians(camera.latitude));
  } else {
    camera.latitude -= std::copysign(degrees, camera.latitude);
  }
  return scene;
}

// Light as it is fitted into a picture, more or less; what a normal is told by keeps its sign.
double shown(double value) { return value / (1.0 + std::abs(value)); }

double mean_square_difference(Pixels a, Pixels b) {
  double squares = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) squares += std::pow(double{a[i]} - double{b[i]}, 2);
  return squares / static_cast<double>(std::max<std::size_t>(1, a.size()));
}

}  // namespace

Jitter jitter_between(Pixels before, Pixels after, int width, int height, int channels, double allowance) {
  CHECK(before.size() == after.size(), before.size(), " and ", after.size());
  const ChannelField from(before, width, channels), to(after, width, channels);
  Jitter jitter;
  std::vector<double> moves;
  for (int y = 1; y + 1 < height; ++y) {
    for (int x = 1; x + 1 < width; ++x) {
      if (!is_planet(from, x, y)) continue;
      ++jitter.planet;
      const double slope = slope_at(from, x, y), noise = rounding * from.size(x, y);
      if (slope * bound < noise) continue;
      double squares = 0.0;
      for (int c = 0; c < channels; ++c) squares += std::pow(to.at(x, y, c) - from.at(x, y, c), 2);
      const double change = std::sqrt(squares);
      moves.push_back(std::isfinite(change) ? std::max(0.0, change - allowance) / slope
                                            : std::numeric_limits<double>::infinity());
    }
  }
  if (moves.empty()) return jitter;
  jitter.measured = static_cast<double>(moves.size()) / static_cast<double>(jitter.planet);
  std::sort(moves.begin(), moves.end());
  jitter.largest = moves.back();
  jitter.nearly_all = moves[moves.size() - 1 - moves.size() / 100];
  return jitter;
}

Jitter jitter_of(Renderer& renderer, const Scene& scene, const View& view, Channel channel) {
  const std::vector<float> before = draw(renderer, scene, view, channel);
  const double angle = step * renderer.pose().pixel_angle * renderer.pose().clearance;
  const std::vector<float> after = draw(renderer, moved(scene, angle), view, channel);
  const bool normal = channel == Channel::normal;
  return jitter_between(before, after, view.width, view.height, normal ? 3 : 1, normal ? 0.0 : angle);
}

Motion motion_between(Pixels first, Pixels second, Pixels third) {
  CHECK(first.size() == second.size() && second.size() == third.size(), first.size(), " floats");
  struct Change {
    double squares, bends;
  };
  std::vector<Change> changes;
  for (std::size_t i = 0; i + 3 < first.size(); i += 4) {
    Change change{0.0, 0.0};
    for (std::size_t c = i; c < i + 3; ++c) {
      const double a = shown(first[c]), b = shown(second[c]), d = shown(third[c]);
      change.squares += 0.5 * ((b - a) * (b - a) + (d - b) * (d - b));
      change.bends += (d - 2.0 * b + a) * (d - 2.0 * b + a);
    }
    changes.push_back(change);
  }
  std::sort(changes.begin(), changes.end(), [](const Change& a, const Change& b) { return a.bends < b.bends; });
  changes.resize(changes.size() - changes.size() / 50);
  Change sum{0.0, 0.0};
  for (const Change& change : changes) sum = {sum.squares + change.squares, sum.bends + change.bends};
  Motion motion;
  if (sum.squares > 0.0) {
    motion.change = std::sqrt(sum.squares / (3.0 * static_cast<double>(changes.size())));
    motion.unrest = std::sqrt(sum.bends / sum.squares);
  }
  return motion;
}

Motion motion_at(Renderer& renderer, const Scene& scene, View view, double seconds, Channel channel) {
  std::array<std::vector<float>, 3> pictures;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    view.seconds = seconds + static_cast<double>(i) / 60.0;
    pictures[i] = draw(renderer, scene, view, channel);
  }
  return motion_between(pictures[0], pictures[1], pictures[2]);
}

double light_psnr(Pixels a, Pixels b) { return -10.0 * std::log10(mean_square_difference(a, b)); }

}  // namespace terrella
