// Small pictures of all presets.
#pragma once

#include <memory>
#include <vector>

#include "gl/target.hpp"
#include "render/renderer.hpp"

namespace terrella {

class PresetPictures {
 public:
  // Draws the next one, unless a shader for it is still being compiled: call it again. What the context binds is other
  // than before. A renderer of its own lives until all are drawn.
  void advance();

  [[nodiscard]] bool complete() const;

  // Names of the textures, bottom row first, in the order of presets(): those drawn so far.
  [[nodiscard]] std::vector<unsigned> textures() const;

 private:
  std::unique_ptr<Renderer> renderer_;
  std::vector<std::unique_ptr<gl::Target>> pictures_;
};

}  // namespace terrella
