#include "gl/height_texture.hpp"

#include <algorithm>

namespace terrella::gl {

namespace {

int rows_from(const HeightMap& map, std::size_t first) {
  int rows = 1;
  for (std::size_t i = first; i < map.levels().size(); ++i) rows += map.levels()[i].height;
  return rows;
}

}  // namespace

HeightTexture::HeightTexture(const HeightMap& map) : serial_(map.serial()) {
  GLint largest = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
  std::size_t first = 0;
  while (std::max(map.levels()[first].width, rows_from(map, first)) > largest) ++first;
  const int width = map.levels()[first].width, rows = rows_from(map, first);
  glBindTexture(GL_TEXTURE_2D, texture_.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R32F, width, rows, 0, GL_RED, GL_FLOAT, nullptr);
  const auto height = static_cast<float>(map.levels()[first].height);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 1, 1, GL_RED, GL_FLOAT, &height);
  int row = 1;
  for (const HeightMap::Level& of : map.levels().subspan(first)) {
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, row, of.width, of.height, GL_RED, GL_FLOAT, of.heights.data());
    row += of.height;
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  memory_.set(std::int64_t{width} * rows * static_cast<std::int64_t>(sizeof(float)));
}

void HeightTexture::keep(std::optional<HeightTexture>& texture, const HeightMap* map) {
  if (map == nullptr) return texture.reset();
  if (!texture || texture->serial_ != map->serial()) texture.emplace(*map);
}

void HeightTexture::bind(int unit) const {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, texture_.name());
}

}  // namespace terrella::gl
