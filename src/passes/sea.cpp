#include "passes/sea.hpp"

#include <array>

namespace terrella {
namespace {

constexpr std::size_t most_waves = 100;

// As in shaders/wave_block.glsl, std140.
struct WaveBlock {
  std::array<glm::vec4, most_waves> origin;
  std::array<glm::vec4, most_waves> motion;
};

WaveBlock wave_block(const Sea& sea) {
  WaveBlock block{};
  for (std::size_t i = 0; i < sea.waves.size(); ++i) {
    const f32::Wave& wave = sea.waves[i];
    block.origin.at(i) = glm::vec4(wave.origin, wave.amplitude);
    block.motion.at(i) = glm::vec4(wave.wavenumber, wave.phase, wave.pinch, 0.0F);
  }
  return block;
}

}  // namespace

SeaPass::SeaPass(Water technique, SphereMeshes& spheres)
    : spheres_(spheres), program_(technique == Water::calm ? "water/calm" : "water/waves") {}

void SeaPass::draw(const Frame& frame) {
  if (frame.needs.water == Water::waves) {
    const WaveBlock block = wave_block(frame.sea);
    waves_.set(gl::block_waves, std::as_bytes(std::span(&block, 1)));
  }
  program_.use();
  const double level = 1.0 + frame.scene.water.level / frame.scene.planet.radius;
  SphereMeshes::draw_visible(spheres_.directions(frame.needs.water_level), frame.needs.water_level, frame.pose.eye,
                             0.999 * level - frame.sea.highest, level + frame.sea.highest);
}

}  // namespace terrella
