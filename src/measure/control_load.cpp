#include "measure/control_load.hpp"

namespace terrella {
namespace {

constexpr int copies = 4;

}  // namespace

ControlLoad::ControlLoad()
    : from_(1024, 1024, gl::Format::rgba8, gl::Depth::none), to_(700, 700, gl::Format::rgba8, gl::Depth::none) {
  from_.begin();
  glClearColor(0.2F, 0.4F, 0.6F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
}

void ControlLoad::draw() const {
  for (int i = 0; i < copies; ++i) {
    gl::copy(from_, {to_.framebuffer(), to_.image().width(), to_.image().height()});
  }
}

}  // namespace terrella
