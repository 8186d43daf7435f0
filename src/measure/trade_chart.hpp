// Time against accuracy, drawn.
#pragma once

#include <string>

#include "measure/trade.hpp"

namespace terrella {

// An SVG of all settings by what a frame takes (ms, logarithmic) and how near its pictures are to the truth (dB), with
// the front as a line and the presets by name. width, height: of its own coordinates, in which letters are 13 high.
std::string trade_chart(const TradeReport& report, double width, double height);

}  // namespace terrella
