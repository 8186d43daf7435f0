#include "gl/target.hpp"

#include "base/check.hpp"

namespace terrella::gl {

Target::Target(int width, int height, Format format, Depth depth) : image_(width, height, format) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, image_.name(), 0);
  if (depth == Depth::read) {
    depths_.emplace(width, height, Format::depth32f);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depths_->name(), 0);
  } else if (depth == Depth::drawn) {
    glBindRenderbuffer(GL_RENDERBUFFER, depth_.name());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT32F, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_.name());
    memory_.set(std::int64_t{width} * height * 4);
  }
#ifndef __EMSCRIPTEN__  // where the answer is known, and would wait until the driver has done all that it was told
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  CHECK(status == GL_FRAMEBUFFER_COMPLETE, status, width, height);
#endif
}

void Target::begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glViewport(0, 0, image_.width(), image_.height());
}

std::vector<float> Target::read_floats() const {
  const auto count = 4 * static_cast<std::size_t>(image_.width()) * static_cast<std::size_t>(image_.height());
  std::vector<float> pixels(count);
  begin();
  glReadPixels(0, 0, image_.width(), image_.height(), GL_RGBA, GL_FLOAT, pixels.data());
  return pixels;
}

std::vector<unsigned char> Target::read_bytes() const {
  const auto count = 4 * static_cast<std::size_t>(image_.width()) * static_cast<std::size_t>(image_.height());
  std::vector<unsigned char> pixels(count);
  begin();
  glReadPixels(0, 0, image_.width(), image_.height(), GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  return pixels;
}

void CubeTarget::begin(const CubeMap& map, int face, int first, int end) const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0,
                         GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face), map.name(), 0);
  glViewport(0, 0, map.side(), map.side());
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, first, map.side(), end - first);
}

void CubeTarget::end() { glDisable(GL_SCISSOR_TEST); }

void make_opaque(const Target& picture) {
  constexpr float opaque[] = {0.0F, 0.0F, 0.0F, 1.0F};
  picture.begin();
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  glClearBufferfv(GL_COLOR, 0, opaque);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void fill(const CubeMap& map, const std::array<float, 4>& value) {
  const CubeTarget target;
  for (int face = 0; face < 6; ++face) {
    target.begin(map, face, 0, map.side());
    glClearBufferfv(GL_COLOR, 0, value.data());
  }
  CubeTarget::end();
}

void Screen::begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, width, height);
}

namespace {

// Browsers clear a canvas that they have shown before the first draw or clear that follows, but not before a blit: they
// would clear what was copied. So a clear comes before it; of one pixel, which costs nothing.
void claim(const Screen& screen) {
  const Scissors corner({0, 0, 1, 1});
  screen.begin();
  glClear(GL_COLOR_BUFFER_BIT);
}

}  // namespace

void copy(const Target& picture, const Screen& screen) {
  claim(screen);
  const int w = picture.image().width(), h = picture.image().height();
  const bool same = w == screen.width && h == screen.height;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, picture.framebuffer());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, screen.framebuffer);
  glBlitFramebuffer(0, 0, w, h, 0, 0, screen.width, screen.height, GL_COLOR_BUFFER_BIT, same ? GL_NEAREST : GL_LINEAR);
}

Scissors::Scissors(const Pixels& pixels) {
  glEnable(GL_SCISSOR_TEST);
  glScissor(pixels.left, pixels.bottom, pixels.width, pixels.height);
}

Scissors::~Scissors() { glDisable(GL_SCISSOR_TEST); }

}  // namespace terrella::gl
