// Where drawing goes.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "gl/texture.hpp"

namespace terrella::gl {

enum class Depth { none, drawn, read };

// A picture to draw into, with depths if asked, which may be read afterwards.
class Target {
 public:
  Target(int width, int height, Format format, Depth depth);

  // Directs drawing here and sets the viewport to the whole of it.
  void begin() const;

  [[nodiscard]] const Image& image() const { return image_; }
  [[nodiscard]] Image& image() { return image_; }
  // Of Depth::read.
  [[nodiscard]] const Image& depths() const { return *depths_; }
  [[nodiscard]] GLuint framebuffer() const { return framebuffer_.name(); }

  // Reads it back: four channels, bottom row first. Waits for the GPU.
  [[nodiscard]] std::vector<float> read_floats() const;
  [[nodiscard]] std::vector<unsigned char> read_bytes() const;

 private:
  Image image_;
  FramebufferHandle framebuffer_;
  std::optional<Image> depths_;
  RenderbufferHandle depth_;
  Holding memory_;
};

// Draws into rows of one face of a cube map.
class CubeTarget {
 public:
  // Directs drawing to rows [first, end) of a face 0..5.
  void begin(const CubeMap& map, int face, int first, int end) const;
  static void end();

 private:
  FramebufferHandle framebuffer_;
};

// Sets the fourth channel of all pixels to 1.
void make_opaque(const Target& picture);

// Gives all texels of the finest level one value.
void fill(const CubeMap& map, const std::array<float, 4>& value);

// A window, a canvas, or another framebuffer of the caller's.
struct Screen {
  GLuint framebuffer;
  int width, height;  // pixels

  // Directs drawing there and sets the viewport to the whole of it.
  void begin() const;
};

// Copies a picture to all of a screen, scaled to it.
void copy(const Target& picture, const Screen& screen);

// A rectangle of pixels, from the bottom left.
struct Pixels {
  int left = 0, bottom = 0, width = 0, height = 0;

  bool operator==(const Pixels&) const = default;
};

// Keeps drawing to a rectangle as long as it lives.
class Scissors {
 public:
  explicit Scissors(const Pixels& pixels);
  ~Scissors();
  Scissors(const Scissors&) = delete;
  Scissors& operator=(const Scissors&) = delete;
};

}  // namespace terrella::gl
