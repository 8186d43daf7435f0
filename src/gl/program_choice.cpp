#include "gl/program_choice.hpp"

#include <algorithm>

namespace terrella::gl {

void ProgramChoice::want(std::string_view name) {
  const auto found = std::find_if(programs_.begin(), programs_.end(), [&](const auto& p) { return p->name() == name; });
  wanted_ =
      found != programs_.end() ? found->get() : programs_.emplace_back(std::make_unique<Program>(name, vertex_)).get();
}

Program& ProgramChoice::use(bool patient) {
  if (patient || wanted_->ready()) used_ = wanted_;
  if (used_ == nullptr) {
    const auto found = std::find_if(programs_.begin(), programs_.end(), [](const auto& p) { return p->ready(); });
    used_ = found != programs_.end() ? found->get() : wanted_;
  }
  used_->use();
  return *used_;
}

}  // namespace terrella::gl
