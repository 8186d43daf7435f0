// A place for one technique at a time.
#pragma once

#include <memory>
#include <utility>

namespace terrella {

// Kind is an enumeration with a member none; Technique is built anew when the kind changes and gone when it is none. It
// may be what several techniques have in common: then make builds the one of a kind.
template <class Kind, class Technique>
class Slot {
 public:
  template <class... Arguments>
  void choose(Kind kind, Arguments&&... arguments) {
    choose_made(kind, [&](Kind) { return std::make_unique<Technique>(std::forward<Arguments>(arguments)...); });
  }

  // make(kind): a pointer that owns it.
  template <class Make>
  void choose_made(Kind kind, const Make& make) {
    if (kind == kind_) return;
    technique_.reset();
    if (kind != Kind::none) technique_ = make(kind);
    kind_ = kind;
  }

  [[nodiscard]] Technique* get() { return technique_.get(); }
  explicit operator bool() const { return technique_ != nullptr; }
  Technique* operator->() { return &*technique_; }
  const Technique* operator->() const { return &*technique_; }

  // An empty slot is ready.
  bool ready() { return !technique_ || technique_->ready(); }

 private:
  Kind kind_ = Kind::none;
  std::unique_ptr<Technique> technique_;
};

}  // namespace terrella
