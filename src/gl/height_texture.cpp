#include "gl/height_texture.hpp"

#include <algorithm>

namespace terrella::gl {

HeightTexture::HeightTexture(const HeightMap& map) : serial_(map.serial()) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  GLint level = 0;
  std::int64_t bytes = 0;
  for (const HeightMap::Level& of : map.levels()) {
    if (std::max(of.width, of.height) > largest) continue;
    glTexImage2D(GL_TEXTURE_2D, level++, GL_R32F, of.width, of.height, 0, GL_RED, GL_FLOAT, of.heights.data());
    bytes += static_cast<std::int64_t>(of.heights.size() * sizeof(float));
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, level - 1);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  memory_.set(bytes);
}

void HeightTexture::bind(int unit) const {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, texture_.name());
}

}  // namespace terrella::gl
