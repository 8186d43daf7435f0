#include "passes/sea.hpp"

#include <algorithm>
#include <array>
#include <numbers>
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
  for (std::size_t i = 0; i < static_cast<std::size_t>(drawn_long_waves(sea)); ++i) {
    const f64::Wave& wave = sea.waves[i];
    block.origin.at(i) = glm::vec4(glm::dvec4(wave.origin, wave.amplitude));
    block.motion.at(i) = glm::vec4(wave.wavenumber, wave.phase, wave.pinch, 0.0);
  }
  return block;
}

// The first short wave that vertices of nodes don't carry. spacing: of vertices, rad; of deep nodes every second is
// drawn. Straight lines between eight of them in a wave miss it by a thirteenth at the most; over ground that is felt
// waves are shorter, most not half as long.
int first_not_carried(const Sea& sea, NodeLayer layer, double spacing) {
  constexpr double vertices_a_wave = 8.0;
  const double apart = (layer == NodeLayer::deep_sea ? 2.0 : 4.0) * spacing;
  const double last = 2.0 * std::numbers::pi / (vertices_a_wave * apart);
  const auto first = std::find_if(sea.short_waves.begin(), sea.short_waves.end(),
                                  [&](const RegionalWave& wave) { return wave.wavenumber > last; });
  return static_cast<int>(first - sea.short_waves.begin());
}

}  // namespace

SeaPass::SeaPass(Water technique, SphereMeshes& spheres) : technique_(technique), spheres_(spheres) {}

void SeaPass::want(const Needs& needs) {
  const bool over_nodes = has_real_size && has_nodes(needs.ground);
  if (!program_ || over_nodes != over_nodes_) {
    over_nodes_ = over_nodes;
    const bool waves = technique_ == Water::waves;
    deep_program_.reset();
    if (over_nodes) deep_program_.emplace(waves ? "water/waves_deep_nodes" : "water/nodes");
    program_.emplace(over_nodes ? (waves ? "water/waves_nodes" : "water/nodes") : waves ? "water/waves" : "water/calm");
  }
  const std::string name = technique_ == Water::waves ? "water/waves"
                           : needs.ripple_layers > 0  ? "water/rippled"
                                                      : "water/calm";
  const char* seen_from = needs.in_water ? "_in_water" : "";
  if (over_nodes) {
    const char* mirrors = mirrors_land_ ? "_land" : needs.clouds != Clouds::none ? "_cloudy" : "";
    deep_program_->want(name + "_deep_nodes" + mirrors);
    return program_->want(name + (needs.ground_mapped ? "_nodes_mapped" : "_nodes") + seen_from);
  }
  program_->want(name + (refines_ground(needs) ? "_near" : "") + seen_from);
}

void SeaPass::mirror_land(const Needs& needs, bool mirrors_land) {
  if (mirrors_land == mirrors_land_) return;
  mirrors_land_ = mirrors_land;
  want(needs);
}

void SeaPass::draw(const Frame& frame, const GroundPass* ground) {
  // Its other side is seen from the water alone.
  if (frame.needs.in_water) glDisable(GL_CULL_FACE);
  if (!over_nodes_) {
    draw_sphere(frame, ground != nullptr ? ground->ranges() : std::span<const RadiusRange>());
  } else if (has_real_size) {  // nothing is over nodes elsewhere, but only this tells a linker
    draw_over(frame, *ground->nodes(frame.ground_shown));
  }
  glEnable(GL_CULL_FACE);
}

void SeaPass::draw_over(const Frame& frame, const NodeMeshes& nodes) {
  const bool patient = frame.effort == Effort::complete;
  const auto draw = [&](const gl::Program& program, NodeLayer layer) {
    nodes.draw(frame, program, layer, [&](double spacing) {
      if (technique_ == Water::waves) program.set("first_of_pixel", first_not_carried(frame.sea, layer, spacing));
    });
  };
  draw(program_->use(patient), NodeLayer::sea);
  draw(deep_program_->use(patient), NodeLayer::deep_sea);
}

void SeaPass::set_waves(const Frame& frame) {
  if (technique_ != Water::waves) return;
  if (has_real_size && over_nodes_) short_waves_.set(frame);
  const WaveBlock block = wave_block(frame.sea);
  waves_.set(gl::block_waves, std::as_bytes(std::span(&block, 1)));
}

void SeaPass::draw_sphere(const Frame& frame, std::span<const RadiusRange> ground) {
  program_->use(frame.effort == Effort::complete);
  const RadiusRange water = water_range(frame);
  std::vector<float> tops(group_count, static_cast<float>(water.highest));
  for (std::size_t g = 0; g < ground.size(); ++g) {
    if (ground[g].lowest > water.highest) tops[g] = 0.0F;
  }
  spheres_.directions(frame.needs.water_level).draw(frame, visible_groups(sight_of(frame), water.lowest, tops));
}

}  // namespace terrella
