// The trade as a page, for people.
#pragma once

#include <optional>
#include <string>

#include "measure/against.hpp"
#include "measure/trade.hpp"

namespace terrella {

// A whole page that asks nothing of any host. comparison: with an older report, if there is one.
std::string trade_page(const TradeReport& report, const std::optional<Comparison>& comparison);

}  // namespace terrella
