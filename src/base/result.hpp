#pragma once

#include <string>
#include <utility>
#include <variant>

#include "base/check.hpp"

namespace terrella {

// Why something could not be done, in a sentence for the user.
struct Failure {
  std::string sentence;
};

// What was asked for, or a sentence that says why there is none.
template <class T>
class Result {
 public:
  Result(T value) : outcome_(std::move(value)) {}
  Result(Failure failure) : outcome_(std::move(failure)) {}

  explicit operator bool() const { return std::holds_alternative<T>(outcome_); }

  T& operator*() {
    CHECK(*this, sentence());
    return std::get<T>(outcome_);
  }
  const T& operator*() const { return const_cast<Result&>(*this).operator*(); }
  T* operator->() { return &**this; }
  const T* operator->() const { return &**this; }

  // Empty where there is a value.
  std::string sentence() const { return *this ? std::string() : std::get<Failure>(outcome_).sentence; }

 private:
  std::variant<T, Failure> outcome_;
};

// A deed that yields nothing but may fail.
using Done = std::monostate;

}  // namespace terrella
