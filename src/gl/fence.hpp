// A place in the stream of commands, to learn whether the GPU has come past it.
#pragma once

#include <utility>

#include "gl/api.hpp"

namespace terrella::gl {

class Fence {
 public:
  // Behind all commands so far, which are sent on their way.
  Fence() : sync_(glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0)) { glFlush(); }
  ~Fence() {
    if (sync_ != nullptr) glDeleteSync(sync_);
  }
  Fence(Fence&& other) noexcept : sync_(std::exchange(other.sync_, nullptr)) {}
  Fence& operator=(Fence&& other) noexcept {
    std::swap(sync_, other.sync_);
    return *this;
  }
  Fence(const Fence&) = delete;
  Fence& operator=(const Fence&) = delete;

  // Whether it was passed; does not wait.
  [[nodiscard]] bool passed() const { return sync_ == nullptr || glClientWaitSync(sync_, 0, 0) != GL_TIMEOUT_EXPIRED; }

 private:
  GLsync sync_;
};

}  // namespace terrella::gl
