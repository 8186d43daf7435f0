// Programs that do one job in more or less detail.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "gl/program.hpp"

namespace terrella::gl {

// One of them is wanted at a time. While a newly wanted one is compiled in the background, the one before goes on being
// used. All that were wanted are kept.
class ProgramChoice {
 public:
  // All share the vertex shader shaders/<vertex>.vert.
  explicit ProgramChoice(std::string_view vertex) : vertex_(vertex) {}

  // Starts to compile shaders/<name>.frag if that has not been done.
  void want(std::string_view name);

  // True once use() will not wait for the wanted program.
  bool ready() { return wanted_->ready(); }

  // Whether the last one used is the wanted one.
  [[nodiscard]] bool settled() const { return used_ == wanted_; }

  // Makes the wanted program the current one; if that would mean to wait and patient is false, the last one used, or
  // else any that is ready.
  // Returns the one in use.
  Program& use(bool patient);

 private:
  std::string vertex_;
  std::vector<std::unique_ptr<Program>> programs_;
  Program* wanted_ = nullptr;
  Program* used_ = nullptr;
};

}  // namespace terrella::gl
