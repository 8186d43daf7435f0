#include "passes/sea.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "passes/node_meshes.hpp"
#include "planet/real_size.hpp"

namespace terrella {
namespace {

// As in shaders/wave_block.glsl, std140.
struct WaveBlock {
  std::array<glm::vec4, most_long_waves> origin;
  std::array<glm::vec4, most_long_waves> motion;
};

WaveBlock wave_block(const Sea& sea) {
  WaveBlock block{};
  for (std::size_t i = 0; i < std::min(sea.waves.size(), most_long_waves); ++i) {
    const f64::Wave& wave = sea.waves[i];
    block.origin.at(i) = glm::vec4(glm::dvec4(wave.origin, wave.amplitude));
    block.motion.at(i) = glm::vec4(wave.wavenumber, wave.phase, wave.pinch, 0.0);
  }
  return block;
}

}  // namespace

SeaPass::SeaPass(Water technique, SphereMeshes& spheres) : technique_(technique), spheres_(spheres) {}

void SeaPass::want(const Needs& needs) {
  const bool over_nodes = has_real_size && has_nodes(needs.ground);
  if (!program_ || over_nodes != over_nodes_) {
    over_nodes_ = over_nodes;
    const bool waves = technique_ == Water::waves;
    program_.emplace(over_nodes ? (waves ? "water/waves_nodes" : "water/nodes") : waves ? "water/waves" : "water/calm");
  }
  if (over_nodes) {
    const std::string name = technique_ == Water::waves ? "water/waves_nodes"
                             : needs.ripple_layers > 0  ? "water/rippled_nodes"
                                                        : "water/calm_nodes";
    return program_->want(name + (needs.ground_mapped ? "_mapped" : ""));
  }
  const bool near = refines_ground(needs);
  if (needs.water == Water::waves) return program_->want(near ? "water/waves_near" : "water/waves");
  if (needs.ripple_layers > 0) return program_->want(near ? "water/rippled_near" : "water/rippled");
  program_->want(near ? "water/calm_near" : "water/calm");
}

void SeaPass::draw(const Frame& frame, const GroundPass* ground) {
  if (!over_nodes_) return draw_sphere(frame, ground != nullptr ? ground->ranges() : std::span<const RadiusRange>());
  if (!has_real_size) return;  // where nothing is over nodes, but only this tells a linker
  if (technique_ == Water::waves) {
    set_waves(frame);
    short_waves_.set(frame);
  }
  const gl::Program& program = program_->use(frame.effort == Effort::complete);
  ground->nodes(frame.ground_shown)->draw(frame, program, NodeLayer::sea);
}

void SeaPass::set_waves(const Frame& frame) {
  const WaveBlock block = wave_block(frame.sea);
  waves_.set(gl::block_waves, std::as_bytes(std::span(&block, 1)));
}

void SeaPass::draw_sphere(const Frame& frame, std::span<const RadiusRange> ground) {
  if (frame.needs.water == Water::waves) set_waves(frame);
  program_->use(frame.effort == Effort::complete);
  const RadiusRange water = water_range(frame);
  std::vector<float> tops(group_count, static_cast<float>(water.highest));
  for (std::size_t g = 0; g < ground.size(); ++g) {
    if (ground[g].lowest > water.highest) tops[g] = 0.0F;
  }
  spheres_.directions(frame.needs.water_level).draw(frame, visible_groups(sight_of(frame), water.lowest, tops));
}

}  // namespace terrella
