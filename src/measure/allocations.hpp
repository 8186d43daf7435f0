// How often memory is asked for: a program that counts has its operator new replaced.
#pragma once

#include <cstdint>

namespace terrella {

// By this thread since it began.
std::int64_t allocations();

}  // namespace terrella
