// The path of quality out of a report: for the program, and as a table for people.
#pragma once

#include <string>
#include <vector>

#include "measure/trade.hpp"

namespace terrella {

// The settings that a program holding a budget walks along, by number, from the cheapest: the presets, and of the path
// what lies well apart from them and from each other.
std::vector<std::size_t> walked_settings(const TradeReport& report);

// Them as the text of src/scene/quality_path.inc.
std::string path_inc(const TradeReport& report);

// The scene's own setting and the steps of the program's path as a table in Markdown, times as multiples of the own
// one's; if the steps were not measured, the presets of the report.
std::string path_table(const TradeReport& report);

}  // namespace terrella
