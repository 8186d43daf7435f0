#include "passes/wave_lists.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

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
  glm::vec4 breaking;
  glm::vec4 left;
  glm::ivec4 begin, go_on;
  List list;
};

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
    texels[2 * i + 1] = glm::vec4(glm::dvec4(wave.amplitude, wave.pinch, wave.bend, variance));
  }
  return texels;
}

// Fills a list with as many waves of each axis as it has an equal part of room for, from where those of the list before
// ended, and notes where they begin and end. taken: waves of each axis that are in a list.
void fill(List& list, glm::ivec4& begin, const std::array<Texels, axes>& all, int regions_here,
          std::array<int, axes>& taken) {
  int end = 0;
  for (int axis = 0; axis < axes; ++axis) {
    const auto place = static_cast<std::size_t>(axis);
    const int count = static_cast<int>(all.at(place).size()) / 2;
    const int here = std::min(count - taken.at(place), room / std::max(regions_here, 1));
    std::copy_n(all.at(place).begin() + 2 * taken.at(place), 2 * here, list.begin() + 2 * end);
    begin[axis] = end;
    end += here;
    taken.at(place) += here;
  }
  begin[axes] = end;
}

}  // namespace

void WaveLists::set(const Frame& frame) {
  const NearWaves near = near_waves(frame.sea, frame.pose.eye);
  NearWaveBlock block{};
  List more{};
  const double over_sea = glm::length(frame.pose.eye) - water_radius(frame.scene);
  block.anchor = glm::vec4(glm::dvec4(near.anchor, over_sea));
  block.east = glm::vec4(glm::dvec4(near.axes.east, 0.0));
  block.north = glm::vec4(glm::dvec4(near.axes.north, 0.0));
  const f64::Breaking& breaking = frame.sea.breaking;
  block.breaking = glm::vec4(breaking.fold, breaking.softness, breaking.choppiness, 0.0);
  std::array<Texels, axes> texels;
  int regions_here = 0;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    texels.at(axis) = texels_of(near.waves.at(axis));
    if (!texels.at(axis).empty()) ++regions_here;
  }
  std::array<int, axes> taken{};
  fill(block.list, block.begin, texels, regions_here, taken);
  fill(more, block.go_on, texels, regions_here, taken);
  for (int axis = 0; axis < axes; ++axis) {
    const auto place = static_cast<std::size_t>(axis);
    const auto next = static_cast<std::size_t>(2 * taken.at(place) + 1);
    if (next < texels.at(place).size()) block.left[axis] = texels.at(place)[next].w;
  }
  first_.set(gl::block_near_waves, std::as_bytes(std::span(&block, 1)));
  second_.set(gl::block_more_waves, std::as_bytes(std::span(&more, 1)));
}

}  // namespace terrella
