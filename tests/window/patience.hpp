#pragma once

#include <chrono>
#include <functional>

namespace terrella::test {

inline constexpr std::chrono::seconds patience{60};  // with a slow and busy machine

// Asks again and again until something holds. False if it does not in all the patience.
bool until(const std::function<bool()>& holds);

}  // namespace terrella::test
