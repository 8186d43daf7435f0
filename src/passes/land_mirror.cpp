#include "passes/land_mirror.hpp"

#include "gl/program.hpp"
#include "passes/light_target.hpp"

namespace terrella {

LandMirror::LandMirror() { clear(); }

void LandMirror::clear() {
  if (land_ && land_->image().width() == 1) return;
  begin_light_target(land_, 1, 1, gl::Format::rgba16f, 0.0F, gl::Depth::read);
  end();
}

void LandMirror::begin(const Mirror& mirror) {
  begin_light_target(land_, mirror.view.width, mirror.view.height, gl::Format::rgba16f, 0.0F, gl::Depth::read);
}

void LandMirror::end() { land_->image().make_mipmaps(); }

void LandMirror::bind() const {
  land_->image().bind(gl::unit_mirror);
  land_->depths().bind(gl::unit_mirror_depths);
}

}  // namespace terrella
