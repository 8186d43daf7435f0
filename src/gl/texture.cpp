#include "gl/texture.hpp"

#include <bit>

#include "base/check.hpp"

namespace terrella::gl {
namespace {

struct Layout {
  GLenum internal, format, type;
  int bytes;
};

Layout layout_of(Format format) {
  switch (format) {
    case Format::rgba8: return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4};
    case Format::rgb10a2: return {GL_RGB10_A2, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV, 4};
    case Format::rgba16f: return {GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, 8};
    case Format::rgba32f: return {GL_RGBA32F, GL_RGBA, GL_FLOAT, 16};
    case Format::depth32f: return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, 4};
  }
  return {};
}

void set_filters(GLenum target, GLenum minify, GLenum magnify) {
  glTexParameteri(target, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(minify));
  glTexParameteri(target, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(magnify));
  glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

}  // namespace

int bytes_of(Format format) { return layout_of(format).bytes; }

Image::Image(int width, int height, Format format) : width_(width), height_(height), format_(format) {
  CHECK(width >= 1 && height >= 1, width, height);
  const Layout layout = layout_of(format);
  glBindTexture(GL_TEXTURE_2D, name());
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(layout.internal), width, height, 0, layout.format, layout.type,
               nullptr);
  // 32 bit floats need not be filterable.
  const GLenum filter = format == Format::rgba32f || format == Format::depth32f ? GL_NEAREST : GL_LINEAR;
  set_filters(GL_TEXTURE_2D, filter, filter);
  memory_.set(std::int64_t{width} * height * layout.bytes);
}

void Image::set_row(int row, std::span<const glm::vec4> texels, int column) const {
  const auto count = static_cast<GLsizei>(texels.size());
  CHECK(count + column <= width_ && row < height_, count, column, width_, row);
  glBindTexture(GL_TEXTURE_2D, name());
  glTexSubImage2D(GL_TEXTURE_2D, 0, column, row, count, 1, GL_RGBA, GL_FLOAT, texels.data());
}

void Image::make_mipmaps() {
  glBindTexture(GL_TEXTURE_2D, name());
  set_filters(GL_TEXTURE_2D, GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
  glGenerateMipmap(GL_TEXTURE_2D);
  memory_.set(std::int64_t{width_} * height_ * bytes_of(format_) * 4 / 3);
}

void Image::bind(int unit) const {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, name());
}

CubeMap::CubeMap(int side, Format format) : side_(side), format_(format) {
  CHECK(side >= 1, side);
  const Layout layout = layout_of(format);
  glBindTexture(GL_TEXTURE_CUBE_MAP, name());
  set_filters(GL_TEXTURE_CUBE_MAP, GL_LINEAR, GL_LINEAR);
  for (GLenum face = 0; face < 6; ++face) {
    glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, static_cast<GLint>(layout.internal), side, side, 0,
                 layout.format, layout.type, nullptr);
  }
  note_memory(1);
}

void CubeMap::bind(int unit, double level) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_CUBE_MAP, name());
  const bool mipmapped = level > 0.0;
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, mipmapped ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
  if (mipmapped && !mipmaps_current_) {
    glGenerateMipmap(GL_TEXTURE_CUBE_MAP);
    mipmaps_current_ = true;
    note_memory(static_cast<int>(std::bit_width(static_cast<unsigned>(side_))));
  }
}

void CubeMap::note_memory(int levels) {
  std::int64_t texels = 0;
  for (int level = 0; level < levels; ++level) texels += 6 * std::int64_t{side_ >> level} * (side_ >> level);
  memory_.set(texels * bytes_of(format_));
}

}  // namespace terrella::gl
