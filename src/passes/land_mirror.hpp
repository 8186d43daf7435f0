// The land that the water mirrors.
#pragma once

#include <memory>

#include "gl/target.hpp"
#include "passes/frame.hpp"

namespace terrella {

class LandMirror {
 public:
  // Of nothing.
  LandMirror();
  void clear();

  // Directs drawing to its picture, in which there is nothing yet.
  void begin(const Mirror& mirror);
  // All that stands there is drawn.
  void end();
  // Lets programs read it.
  void bind() const;

 private:
  std::unique_ptr<gl::Target> land_;
};

}  // namespace terrella
