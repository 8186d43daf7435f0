// A program that pictures do without until it is compiled.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "gl/program.hpp"

namespace terrella::gl {

class LateProgram {
 public:
  // As for Program; nothing is compiled yet.
  explicit LateProgram(std::string_view name, std::string_view vertex = {}) : name_(name), vertex_(vertex) {}

  // Whether the picture at hand can use it. To compile begins with the second call: the first picture is not to queue
  // behind one program more. patient: it can be used at once, and is waited for when it is.
  bool ready(bool patient);

  // Needs ready.
  Program& operator*() { return *program_; }
  Program* operator->() { return &*program_; }

 private:
  std::string name_, vertex_;
  std::optional<Program> program_;
  bool asked_ = false;
};

}  // namespace terrella::gl
