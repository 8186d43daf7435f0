// An OpenGL context without a window or a display.
#pragma once

#include <memory>
#include <string>

#include "base/result.hpp"

namespace terrella {

enum class Api { core, es };  // OpenGL 3.3 core, OpenGL ES 3.0

class EglContext {
 public:
  // Makes a context current for the calling thread, with its caps read and its state set up. Fails with a sentence
  // where the machine has none that can draw a planet.
  static Result<std::unique_ptr<EglContext>> make(Api api);
  ~EglContext();
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

 private:
  EglContext(void* display, void* context) : display_(display), context_(context) {}

  void* display_;
  void* context_;
};

}  // namespace terrella
