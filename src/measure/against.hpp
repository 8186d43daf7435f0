// A trade beside an older one: what became slower or less accurate.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "app/stats.hpp"
#include "base/result.hpp"
#include "measure/trade.hpp"

namespace terrella {

// What of a report.json is compared.
struct TradeSummary {
  struct Setting {
    Spread ms;
    double psnr = 0.0;  // dB
  };

  std::string renderer, cpu, timer;
  std::vector<double> size;  // pixels
  std::string scene;         // as JSON
  std::string cameras;       // their scenes as JSON
  double judged_at = 0.0;    // s
  Spread control_ms;
  std::map<std::string, Setting> settings;  // by id
};

// Reads the text of a report.json, or whatever else it is: then it says why it is none.
Result<TradeSummary> read_trade(std::string_view text);

struct Comparison {
  std::vector<std::string> worse, better;  // a sentence for each setting that is slower or less accurate, or the other
  std::string about_times;                 // what was done about the machine's own speed, or why no times are compared
  int compared = 0;                        // settings that both have
};

// What of it is known before anything is measured: size, scene, moment and cameras.
TradeSummary to_be_measured(const SceneDocument& document, const TradePlan& plan);

// Whether two reports are of the same pictures, so that they can be compared: empty, or a sentence that says why not.
std::string why_not_comparable(const TradeSummary& before, const TradeSummary& now);

// Times, where both were measured on the same machine, are slower where the whole spread (p10 to p90) lies beyond the
// old one by more than a hundredth and by more than the control load became slower, in its median and its p10. Errors
// are the same on the same machine but for rounding: 0.05 dB count; on another one, 0.5 dB.
Comparison compare(const TradeSummary& before, const TradeSummary& now);

}  // namespace terrella
