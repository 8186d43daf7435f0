#pragma once

#include <string>

#include "measure/trade.hpp"

namespace terrella {

// Each knob turned by itself: a table and pictures.
std::string knobs_html(const TradeReport& report);

}  // namespace terrella
