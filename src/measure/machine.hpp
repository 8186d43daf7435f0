#pragma once

#include "measure/trade.hpp"

namespace terrella {

// What is known of this machine before anything is timed. Needs a current context.
Machine this_machine();

}  // namespace terrella
