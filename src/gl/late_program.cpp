#include "gl/late_program.hpp"

#include <utility>

namespace terrella::gl {

bool LateProgram::ready(bool patient) {
  const bool first = !std::exchange(asked_, true);
  if (!program_ && (patient || !first)) program_.emplace(name_, vertex_);
  return patient || (program_ && program_->ready());
}

}  // namespace terrella::gl
