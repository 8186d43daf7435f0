#include "passes/wave_lists.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "planet/shores.hpp"
#include "planet/short_waves.hpp"
#include "planet/spheres.hpp"

namespace terrella {
namespace {

constexpr int room = 500;  // waves in each list
constexpr int axes = 3;

using List = std::array<glm::vec4, 2 * room>;

// As in shaders/node_waves.glsl, std140.
struct NearWaveBlock {
  glm::vec4 anchor, east, north;
  glm::vec4 breaking, shore;
  glm::ivec4 axes, begin, go_on;
  glm::vec4 left;
  List list;
};

static_assert(sizeof(NearWaveBlock) <= 16'384);  // what every driver takes

using Texels = std::vector<glm::vec4>;

// Two a wave.
Texels texels_of(const std::vector<f64::ShortWave>& waves) {
  Texels texels(2 * waves.size());
  double variance = 0.0;  // of the slopes of a wave and of all shorter ones
  for (std::size_t i = waves.size(); i-- > 0;) {
    const f64::ShortWave& wave = waves[i];
    const double slope = wave.amplitude * wave.wavenumber;
    variance += 0.5 * slope * slope;
    texels[2 * i] = glm::vec4(glm::dvec4(wave.direction, wave.wavenumber, wave.phase));
    texels[2 * i + 1] = glm::vec4(glm::dvec4(wave.amplitude, wave.begins, wave.bend, variance));
  }
  return texels;
}

// The waves of a region around an axis.
struct Region {
  int axis;
  Texels texels;
  int taken = 0;  // waves that are in a list

  [[nodiscard]] int left() const { return static_cast<int>(texels.size()) / 2 - taken; }
};

// Fills a list with as many waves of each region as it has an equal part of room for, from where those of the list
// before ended, and notes where they begin and end.
void fill(List& list, glm::ivec4& begin, std::vector<Region>& all) {
  int end = 0;
  for (std::size_t k = 0; k < axes; ++k) {
    begin[static_cast<int>(k)] = end;
    if (k >= all.size()) continue;
    Region& region = all[k];
    const int here = std::min(region.left(), room / static_cast<int>(all.size()));
    std::copy_n(region.texels.begin() + 2 * region.taken, 2 * here, list.begin() + 2 * end);
    end += here;
    region.taken += here;
  }
  begin[axes] = end;
}

}  // namespace

void WaveLists::set(const Frame& frame) {
  const f64::Shore shore = shore_of(frame.scene, frame.sea);
  const NearWaves near = near_waves(frame.sea, frame.pose.eye, shore.felt_depth);
  NearWaveBlock block{};
  List more{};
  const double over_sea = glm::length(frame.pose.eye) - water_radius(frame.scene);
  block.anchor = glm::vec4(glm::dvec4(near.anchor, over_sea));
  block.east = glm::vec4(glm::dvec4(near.axes.east, 0.0));
  block.north = glm::vec4(glm::dvec4(near.axes.north, 0.0));
  const f64::Breaking& breaking = frame.sea.breaking;
  block.breaking = glm::vec4(breaking.fold, breaking.softness, breaking.choppiness, 0.0);
  block.shore =
      glm::vec4(shore.per_slope, shore.felt_depth, frame.sea.slope_variance, foam_layer(frame.scene, frame.sea));
  std::vector<Region> here;
  for (int axis = 0; axis < axes; ++axis) {
    const auto& waves = near.waves.at(static_cast<std::size_t>(axis));
    if (!waves.empty()) here.push_back({axis, texels_of(waves)});
  }
  fill(block.list, block.begin, here);
  fill(more, block.go_on, here);
  block.axes[axes] = static_cast<int>(here.size());
  for (std::size_t k = 0; k < here.size(); ++k) {
    block.axes[static_cast<int>(k)] = here[k].axis;
    if (here[k].left() > 0)
      block.left[static_cast<int>(k)] = here[k].texels[2 * static_cast<std::size_t>(here[k].taken) + 1].w;
  }
  first_.set(gl::block_near_waves, std::as_bytes(std::span(&block, 1)));
  second_.set(gl::block_more_waves, std::as_bytes(std::span(&more, 1)));
}

}  // namespace terrella
