// The trade as report.json, for programs.
#pragma once

#include <string>

#include "measure/trade.hpp"

namespace terrella {

// Raised when what the members mean changes.
inline constexpr int trade_schema = 1;

// The document of the scene with its camera in another place.
SceneDocument as_seen_by(SceneDocument document, const Viewpoint& camera);

// One JSON object; docs/command_line.md tells its members.
std::string trade_json(const TradeReport& report);

}  // namespace terrella
