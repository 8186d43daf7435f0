// A renderer with its own context.
#pragma once

#include <memory>
#include <utility>

#include "native/egl_context.hpp"
#include "render/renderer.hpp"

namespace terrella::test {

struct Studio {
  explicit Studio(Api api = Api::core) : context(std::move(*EglContext::make(api))) {}
  std::unique_ptr<EglContext> context;
  Renderer renderer;
};

}  // namespace terrella::test
