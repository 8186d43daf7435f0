// A uniform block's memory.
#pragma once

#include <cstddef>
#include <span>

#include "gl/handle.hpp"
#include "gl/ledger.hpp"
#include "gl/program.hpp"

namespace terrella::gl {

class UniformBuffer {
 public:
  // Replaces the whole content and binds it to its block.
  void set(Block block, std::span<const std::byte> bytes) {
    glBindBuffer(GL_UNIFORM_BUFFER, buffer_.name());
    glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_DYNAMIC_DRAW);
    bind(block);
    memory_.set(static_cast<std::int64_t>(bytes.size()));
  }

  // Binds it as it is.
  void bind(Block block) const { glBindBufferBase(GL_UNIFORM_BUFFER, block, buffer_.name()); }

 private:
  BufferHandle buffer_;
  Holding memory_;
};

}  // namespace terrella::gl
