// A place for one technique at a time.
#pragma once

#include <optional>
#include <utility>

namespace terrella {

// Kind is an enumeration with a member none; Technique is built anew when the kind changes and gone when it is none.
template <class Kind, class Technique>
class Slot {
 public:
  template <class... Arguments>
  void choose(Kind kind, Arguments&&... arguments) {
    if (kind == kind_) return;
    technique_.reset();
    if (kind != Kind::none) technique_.emplace(std::forward<Arguments>(arguments)...);
    kind_ = kind;
  }

  explicit operator bool() const { return technique_.has_value(); }
  Technique* operator->() { return &*technique_; }
  const Technique* operator->() const { return &*technique_; }

  // An empty slot is ready.
  bool ready() { return !technique_ || technique_->ready(); }

 private:
  Kind kind_ = Kind::none;
  std::optional<Technique> technique_;
};

}  // namespace terrella
