// Textures that passes draw into and read from.
#pragma once

#include <span>

#include <glm/vec4.hpp>

#include "gl/handle.hpp"
#include "gl/ledger.hpp"

namespace terrella::gl {

// What a texel holds.
enum class Format { rgba8, rgb10a2, rgba16f, rgba32f, depth32f };

int bytes_of(Format format);

// A picture that can be drawn into, with linear filtering, but for 32 bit floats and depths, and clamped edges. width,
// height >= 1.
class Image {
 public:
  Image(int width, int height, Format format);

  // texels: of a row from a column on, no more than it has there; of a format of floats.
  void set_row(int row, std::span<const glm::vec4> texels, int column = 0) const;

  // Makes its mipmaps, to be blended where it is read. Of a format that is filtered.
  void make_mipmaps();

  void bind(int unit) const;
  [[nodiscard]] GLuint name() const { return texture_.name(); }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] Format format() const { return format_; }

 private:
  TextureHandle texture_;
  int width_, height_;
  Format format_;
  Holding memory_;
  CountedTexture counted_;
};

// Six square faces around the planet, with mipmaps once they are asked for. side: texels, a power of two or any other
// number >= 1.
class CubeMap {
 public:
  CubeMap(int side, Format format);

  // Makes it readable. level: of the mipmap that will be read, 0 for the whole map; the coarser levels are made, and
  // neighbouring ones blended, only where it is above 0.
  void bind(int unit, double level = 0.0);

  // To be called where the map has been drawn into.
  void changed() { mipmaps_current_ = false; }

  [[nodiscard]] GLuint name() const { return texture_.name(); }
  [[nodiscard]] int side() const { return side_; }

 private:
  void note_memory(int levels);

  TextureHandle texture_;
  int side_;
  Format format_;
  bool mipmaps_current_ = false;
  Holding memory_;
  CountedTexture counted_;
};

}  // namespace terrella::gl
