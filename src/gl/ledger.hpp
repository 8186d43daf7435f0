// What the project asks of the GPU, counted where it is asked: memory held, and work since the last frame began.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace terrella::gl {

struct Ledger {
  std::int64_t bytes = 0;  // held by buffers, textures and render targets
  int textures = 0;        // textures alive
  int draw_calls = 0;      // since begin_frame
  std::int64_t triangles = 0;
  std::vector<std::string> programs;  // names of those that are held
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

// A program by name, listed for as long as its owner lives.
class ListedProgram {
 public:
  explicit ListedProgram(std::string name) : name_(std::move(name)) { ledger().programs.push_back(name_); }
  ~ListedProgram() {
    auto& names = ledger().programs;
    names.erase(std::find(names.begin(), names.end(), name_));
  }
  ListedProgram(const ListedProgram&) = delete;
  ListedProgram& operator=(const ListedProgram&) = delete;
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  std::string name_;
};

void begin_frame();

}  // namespace terrella::gl
