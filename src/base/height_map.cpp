#include "base/height_map.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "base/check.hpp"
#include "base/text.hpp"

namespace terrella {
namespace {

constexpr double pi = std::numbers::pi;
constexpr int fewest_rows = 4;  // of the coarsest level: two beside each pole

std::uint64_t next_serial() {
  static std::atomic<std::uint64_t> last = 0;
  return ++last;
}

// Which texels of a finer row make one of a coarser, and how much of each: where the finer row has an odd number, one
// belongs to two.
struct Share {
  int texel;
  double part;
};

std::vector<Share> shares_of(int texel, int coarse, int fine) {
  const double scale = static_cast<double>(fine) / coarse, from = texel * scale, to = from + scale;
  std::vector<Share> shares;
  for (int i = static_cast<int>(from); i < fine && i < to; ++i) {
    const double part = std::min<double>(to, i + 1) - std::max<double>(from, i);
    if (part > 1e-9) shares.push_back({i, part / scale});
  }
  return shares;
}

HeightMap::Level halved(const HeightMap::Level& fine) {
  HeightMap::Level coarse = {std::max(fine.width / 2, 1), std::max(fine.height / 2, 1), {}, 0.0};
  coarse.heights.reserve(static_cast<std::size_t>(coarse.width) * static_cast<std::size_t>(coarse.height));
  std::vector<std::vector<Share>> columns;
  for (int x = 0; x < coarse.width; ++x) columns.push_back(shares_of(x, coarse.width, fine.width));
  for (int y = 0; y < coarse.height; ++y) {
    const std::vector<Share> rows = shares_of(y, coarse.height, fine.height);
    for (const std::vector<Share>& column : columns) {
      double sum = 0.0;
      for (const Share& row : rows) {
        const float* heights =
            &fine.heights[static_cast<std::size_t>(row.texel) * static_cast<std::size_t>(fine.width)];
        for (const Share& of : column) sum += row.part * of.part * static_cast<double>(heights[of.texel]);
      }
      coarse.heights.push_back(static_cast<float>(sum));
    }
  }
  return coarse;
}

// The sine of the angle from the pole to the middle of a row.
double sine_of_row(int row, int rows) { return std::sin(pi * (row + 0.5) / rows); }

// The mean of as many texels around each, along a ring.
void smooth_ring(std::span<float> ring, int width) {
  const auto n = static_cast<int>(ring.size());
  std::vector<double> sums = {0.0};  // of all before, once around and the width more
  for (int i = 0; i < n + width; ++i)
    sums.push_back(sums.back() + static_cast<double>(ring[static_cast<std::size_t>(i % n)]));
  for (int i = 0; i < n; ++i) {
    const auto from = static_cast<std::size_t>((i - width / 2 + n) % n);
    ring[static_cast<std::size_t>(i)] =
        static_cast<float>((sums[from + static_cast<std::size_t>(width)] - sums[from]) / width);
  }
}

void smooth_poles(HeightMap::Level& level) {
  for (int y = 0; y < level.height; ++y) {
    const auto columns = static_cast<std::size_t>(level.width);
    const std::span<float> ring(&level.heights[static_cast<std::size_t>(y) * columns], columns);
    const int from_pole = std::min(y, level.height - 1 - y);
    if (from_pole < 2) {
      double sum = 0.0;
      for (const float height : ring) sum += static_cast<double>(height);
      std::fill(ring.begin(), ring.end(), static_cast<float>(sum / static_cast<double>(columns)));
      continue;
    }
    // As many texels as are as wide together as the row is high; an odd number, so that none moves.
    const double wide = 2.0 * pi * sine_of_row(y, level.height) / level.width, high = pi / level.height;
    const int width = 2 * static_cast<int>(0.5 * high / wide) + 1;
    if (width > 1) smooth_ring(ring, std::min(width, (level.width - 1) | 1));
  }
}

double variance_of(const HeightMap::Level& level) {
  double area = 0.0, sum = 0.0, squares = 0.0;
  for (int y = 0; y < level.height; ++y) {
    const double sine = sine_of_row(y, level.height);
    for (int x = 0; x < level.width; ++x) {
      const double height = level.heights[static_cast<std::size_t>(y) * static_cast<std::size_t>(level.width) +
                                          static_cast<std::size_t>(x)];
      area += sine;
      sum += sine * height;
      squares += sine * height * height;
    }
  }
  return std::max(squares / area - (sum / area) * (sum / area), 0.0);
}

// No spline is steeper than neighbours differ. A row is felt as far as two rows nearer to the pole, where a turn is
// shorter.
double steepest_of(const HeightMap& map, int level) {
  const int width = map.levels()[static_cast<std::size_t>(level)].width;
  const int height = map.levels()[static_cast<std::size_t>(level)].height;
  double along = 0.0, down = 0.0;
  for (int y = 0; y < height; ++y) {
    const double nearer = std::max(std::min(y, height - 1 - y) - 1.5, 0.5);
    const double apart = 2.0 * pi / width * std::sin(pi * nearer / height);
    for (int x = 0; x < width; ++x) {
      const double here = map.at(level, x, y);
      along = std::max(along, std::abs(map.at(level, (x + 1) % width, y) - here) / apart);
      if (y > 0) down = std::max(down, std::abs(map.at(level, x, y - 1) - here) / (pi / height));
    }
  }
  return std::hypot(along, down);
}

}  // namespace

HeightMap::HeightMap(int width, int height, std::vector<float> heights) : serial_(next_serial()) {
  CHECK(trouble_with_size("", width, height).empty(), width, height);
  CHECK(heights.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height), heights.size());
  levels_.push_back({width, height, std::move(heights), 0.0});
  smooth_poles(levels_.front());
  while (levels_.back().height / 2 >= fewest_rows) {
    levels_.push_back(halved(levels_.back()));
    smooth_poles(levels_.back());
  }
  for (Level& level : levels_) level.variance = variance_of(level);
  for (std::size_t i = 0; i < levels_.size(); ++i)
    steepest_ = std::max(steepest_, steepest_of(*this, static_cast<int>(i)));
  const auto [least, most] = std::minmax_element(levels_[0].heights.begin(), levels_[0].heights.end());
  lowest_ = *least;
  highest_ = *most;
}

double HeightMap::texel() const { return std::max(2.0 * pi / levels_[0].width, pi / levels_[0].height); }

double HeightMap::unseen_variance(double footprint) const {
  const double last = static_cast<double>(levels_.size()) - 1.0;
  const double level = std::clamp(std::log2(footprint / texel()), 0.0, last);
  const auto finer = static_cast<std::size_t>(level), coarser = std::min(finer + 1, levels_.size() - 1);
  const double seen = std::lerp(levels_[finer].variance, levels_[coarser].variance, level - std::floor(level));
  return std::max(levels_[0].variance - seen, 0.0);
}

std::string trouble_with_size(std::string_view name, std::int64_t width, std::int64_t height) {
  constexpr std::int64_t least = HeightMap::least_height, most = HeightMap::largest_side;
  if (height >= least && width >= height && width <= 4 * height && width <= most) return {};
  return text_of(shortened(name, 200), ": is ", width, "x", height,
                 " pixels; allowed is a map of the whole planet that is ", least, " to ", most,
                 " pixels high, and 1 to 4 times as wide but no wider than ", most,
                 "; most are twice as wide as high.");
}

Result<SharedHeightMap> make_height_map(std::string_view name, int width, int height, std::vector<float> heights) {
  std::string trouble = trouble_with_size(name, width, height);
  if (!trouble.empty()) return Failure{std::move(trouble)};
  const auto wrong = std::find_if_not(heights.begin(), heights.end(), [](float h) { return h >= 0.0F && h <= 1.0F; });
  if (wrong != heights.end()) {
    const auto at = static_cast<std::int64_t>(wrong - heights.begin());
    return Failure{text_of(shortened(name, 200), ": the height in column ", at % width + 1, " of row ", at / width + 1,
                           " is ", static_cast<double>(*wrong), "; allowed are 0 to 1, parts of terrain.height.")};
  }
  return std::make_shared<const HeightMap>(width, height, std::move(heights));
}

}  // namespace terrella
