// Heights over a whole sphere as a picture that spans all longitudes and latitudes (equirectangular), with coarser
// levels.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.hpp"

namespace terrella {

// Level 0 is the map itself; each further one has half as many columns and rows, and holds means. Row 0 lies at the
// north pole, column 0 begins at longitude -180 degrees. Rows near a pole, whose texels are narrow, are as smooth along
// the circle as across it, and the two next to a pole are of one height each: what is interpolated knows no direction
// there.
class HeightMap {
 public:
  static constexpr int least_height = 8, largest_side = 8192;

  // heights: row after row, each 0 to 1. width: height to 4 times height.
  HeightMap(int width, int height, std::vector<float> heights);

  struct Level {
    int width, height;
    std::vector<float> heights;
    double variance;  // of the heights, by area
  };
  [[nodiscard]] std::span<const Level> levels() const { return levels_; }
  [[nodiscard]] float at(int level, int column, int row) const {
    const Level& of = levels_[static_cast<std::size_t>(level)];
    return of
        .heights[static_cast<std::size_t>(row) * static_cast<std::size_t>(of.width) + static_cast<std::size_t>(column)];
  }
  // Distance of neighbouring texels of level 0, the longer one, rad.
  [[nodiscard]] double texel() const;
  // What the splines of lib/height_map.glsl make of any level rises by at most, heights a rad.
  [[nodiscard]] double steepest() const { return steepest_; }
  // Between which heights all of it lies.
  [[nodiscard]] float lowest() const { return lowest_; }
  [[nodiscard]] float highest() const { return highest_; }
  // How much of the variance of heights samples a footprint (rad) apart leave out.
  [[nodiscard]] double unseen_variance(double footprint) const;
  // No other map ever made has the same.
  [[nodiscard]] std::uint64_t serial() const { return serial_; }

 private:
  std::vector<Level> levels_;
  double steepest_ = 0.0;
  float lowest_ = 0.0F, highest_ = 0.0F;
  std::uint64_t serial_;
};

using SharedHeightMap = std::shared_ptr<const HeightMap>;

// Bytes of the largest file that a map may have, and whether the first ones are those of one of its kinds.
inline constexpr std::size_t largest_map_file = std::size_t{1} << 30U;
bool is_height_map(std::string_view bytes);

// The map in the bytes of a file, which its first bytes tell to be a PNG or a portable float map. name: as the user
// knows it; sentences begin with it. Desktop only.
Result<SharedHeightMap> read_height_map(std::string_view name, std::string_view bytes);

// In those of a portable float map, of one channel or three: heights 0 to 1, of colours their luminance.
Result<SharedHeightMap> read_pfm_height_map(std::string_view name, std::string_view bytes);

// In pixels that something else has read, red, green, blue and opacity side by side, row after row.
Result<SharedHeightMap> read_pixels_of_height_map(std::string_view name, int width, int height,
                                                  const unsigned char* rgba);

// The height that a colour stands for.
float luminance(float red, float green, float blue);

// Of heights that something else has read, row after row; a sentence for sizes that are not allowed, and heights beyond
// 0 to 1.
Result<SharedHeightMap> make_height_map(std::string_view name, int width, int height, std::vector<float> heights);

// A sentence where a map of this size is not allowed; else empty.
std::string trouble_with_size(std::string_view name, std::int64_t width, std::int64_t height);

// As a formula holds it: lib/height_map.glsl calls it a texture. The map lives elsewhere; serial tells it from another
// at the same address.
struct HeightTexels {
  const HeightMap* map = nullptr;
  std::uint64_t serial = 0;
  bool operator==(const HeightTexels&) const = default;
};

}  // namespace terrella
