// What the project asks of the GPU, counted where it is asked: memory held, and work since the last frame began.
#pragma once

#include <cstdint>

namespace terrella::gl {

struct Ledger {
  std::int64_t bytes = 0;  // held by buffers, textures and render targets
  int textures = 0;        // textures alive
  int draw_calls = 0;      // since begin_frame
  std::int64_t triangles = 0;
};

Ledger& ledger();

// A share of GPU memory, given back with its owner.
class Holding {
 public:
  Holding() = default;
  ~Holding() { set(0); }
  Holding(Holding&& other) noexcept : bytes_(other.bytes_) { other.bytes_ = 0; }
  Holding& operator=(Holding&& other) noexcept {
    set(other.bytes_);
    other.set(0);
    return *this;
  }
  Holding(const Holding&) = delete;
  Holding& operator=(const Holding&) = delete;

  void set(std::int64_t bytes) {
    ledger().bytes += bytes - bytes_;
    bytes_ = bytes;
  }

 private:
  std::int64_t bytes_ = 0;
};

// One of a kind that the ledger counts, for as long as its owner lives.
class CountedTexture {
 public:
  CountedTexture() { ++ledger().textures; }
  ~CountedTexture() { --ledger().textures; }
  CountedTexture(const CountedTexture&) = delete;
  CountedTexture& operator=(const CountedTexture&) = delete;
};

void begin_frame();

}  // namespace terrella::gl
