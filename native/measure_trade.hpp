#pragma once

#include <optional>
#include <string>

#include "measure/against.hpp"
#include "measure/trade.hpp"
#include "native/egl_context.hpp"

namespace terrella {

struct TradeTask {
  SceneDocument document;
  TradePlan plan;
  Api api = Api::core;
  std::string folder;
  std::string against;                 // the old report's file
  std::optional<TradeSummary> before;  // what it holds; nothing where none is given
};

// `terrella measure`: measures, writes, and tells what became of an old report. Returns what went wrong, or that
// something is slower or less accurate, or nothing.
std::string measure_trade(const TradeTask& task);

}  // namespace terrella
