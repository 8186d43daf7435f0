#include "passes/light_target.hpp"

namespace terrella {

void begin_light_target(std::unique_ptr<gl::Target>& target, int width, int height, gl::Format format, float sky,
                        gl::Depth depth) {
  const gl::Image* image = target ? &target->image() : nullptr;
  if (image == nullptr || image->width() != width || image->height() != height || image->format() != format) {
    target.reset();  // first, so that there is never room for both
    target = std::make_unique<gl::Target>(width, height, format, depth);
  }
  target->begin();
  const float clear[] = {sky, sky, sky, 0.0F};  // alpha: how much of the sky is covered
  const float farthest = 0.0F;                  // depths fall with distance
  glDepthMask(GL_TRUE);
  glClearBufferfv(GL_COLOR, 0, clear);
  glClearBufferfv(GL_DEPTH, 0, &farthest);
}

}  // namespace terrella
