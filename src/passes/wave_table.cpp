#include "passes/wave_table.hpp"

#include <vector>

#include <glm/geometric.hpp>

#include "planet/short_waves.hpp"
#include "planet/spheres.hpp"

namespace terrella {
namespace {

// As in shaders/node_waves.glsl, std140.
struct AnchorBlock {
  glm::vec4 anchor, east, north;
  glm::vec4 breaking;
  glm::ivec4 counts;
};

// Two texels a wave.
std::vector<glm::vec4> texels_of(const std::vector<f64::ShortWave>& waves) {
  std::vector<glm::vec4> texels(2 * waves.size());
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

}  // namespace

void WaveTable::set(const Frame& frame) {
  const NearWaves near = near_waves(frame.sea, frame.pose.eye);
  const int width = std::max(2 * static_cast<int>(frame.sea.short_waves.size()), 1);
  if (!waves_ || waves_->width() != width) waves_.emplace(width, 3, gl::Format::rgba32f);
  AnchorBlock block{};
  const double over_sea = glm::length(frame.pose.eye) - water_radius(frame.scene);
  block.anchor = glm::vec4(glm::dvec4(near.anchor, over_sea));
  block.east = glm::vec4(glm::dvec4(near.axes.east, 0.0));
  block.north = glm::vec4(glm::dvec4(near.axes.north, 0.0));
  const f64::Breaking& breaking = frame.sea.breaking;
  block.breaking = glm::vec4(breaking.fold, breaking.softness, breaking.choppiness, 0.0);
  for (int axis = 0; axis < 3; ++axis) {
    const auto& waves = near.waves.at(static_cast<std::size_t>(axis));
    block.counts[axis] = static_cast<int>(waves.size());
    if (!waves.empty()) waves_->set_row(axis, texels_of(waves));
  }
  waves_->bind(gl::unit_waves);
  anchor_.set(gl::block_wave_anchor, std::as_bytes(std::span(&block, 1)));
}

}  // namespace terrella
