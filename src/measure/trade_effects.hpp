#pragma once

#include <string>

#include "measure/trade.hpp"

namespace terrella {

// What each effect of the scene costs and what would be missing without it, as bars.
std::string effects_html(const TradeReport& report);

}  // namespace terrella
