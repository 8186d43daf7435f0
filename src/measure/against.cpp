#include "measure/against.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "measure/moment.hpp"
#include "measure/trade_json.hpp"
#include "scene/json.hpp"

namespace terrella {
namespace {

using Json = nlohmann::json;  // members in order of their names, however a report has them

constexpr double slower_by = 1.01;
constexpr int deepest = 12;  // level of a report; what lies deeper is none's, and would cost as much stack

// A member of whatever this is; null where there is none.
const Json& member(const Json& json, const char* name) {
  static const Json none;
  if (!json.is_object()) return none;
  const auto found = json.find(name);
  return found == json.end() ? none : *found;
}

std::string text_in(const Json& json) { return json.is_string() ? json.get<std::string>() : std::string(); }

// Not a number where there is none.
double number_in(const Json& json) { return json.is_number() ? json.get<double>() : std::nan(""); }

Spread spread_in(const Json& json) {
  return {number_in(member(json, "median")), number_in(member(json, "p10")), number_in(member(json, "p90"))};
}

bool makes_sense(const Spread& spread) {
  return spread.p10 >= 0.0 && spread.median >= spread.p10 && spread.p90 >= spread.median && std::isfinite(spread.p90);
}

// Adds a setting; returns whether it was one.
bool add_setting(const Json& json, TradeSummary& summary) {
  const std::string id = text_in(member(json, "id"));
  const TradeSummary::Setting setting = {spread_in(member(json, "ms")), number_in(member(json, "psnr"))};
  if (id.empty() || !makes_sense(setting.ms) || !std::isfinite(setting.psnr)) return false;
  summary.settings[id] = setting;
  return true;
}

std::string scenes_of(const Json& cameras) {
  std::string scenes;
  if (!cameras.is_array()) return scenes;
  for (const Json& camera : cameras) scenes += member(camera, "scene").dump() + '\n';
  return scenes;
}

bool same_machine(const TradeSummary& a, const TradeSummary& b) {
  return a.renderer == b.renderer && a.cpu == b.cpu && a.timer == b.timer;
}

std::string ms(const Spread& spread) {
  return text_of(printed_number(spread.median, 3), " ms (", printed_number(spread.p10, 3), " to ",
                 printed_number(spread.p90, 3), ")");
}

// speeds: the least and the greatest factor by which the machine itself may have become slower.
void compare_times(const std::string& id, const Spread& before, const Spread& now, std::pair<double, double> speeds,
                   Comparison& comparison) {
  const auto sentence = [&](const char* how, double speed) {
    return text_of(id, " is ", how, ": ", ms(now), ", after ", ms(before), ", of which ", printed_number(speed, 3),
                   " times is the machine's.");
  };
  if (now.p10 > slower_by * speeds.second * before.p90) comparison.worse.push_back(sentence("slower", speeds.second));
  if (speeds.first * before.p10 > slower_by * now.p90) comparison.better.push_back(sentence("faster", speeds.first));
}

void compare_errors(const std::string& id, double before, double now, double tolerance, Comparison& comparison) {
  const auto sentence = [&](const char* how) {
    return text_of(id, " is ", how, " accurate: ", printed_number(now, 4), " dB after ", printed_number(before, 4),
                   " dB.");
  };
  if (now < before - tolerance) comparison.worse.push_back(sentence("less"));
  if (now > before + tolerance) comparison.better.push_back(sentence("more"));
}

}  // namespace

Result<TradeSummary> read_trade(std::string_view text) {
  const auto not_too_deep = [](int depth, Json::parse_event_t, Json&) { return depth <= deepest; };
  const Json json = Json::parse(text, not_too_deep, false);
  if (json.is_discarded() || !json.is_object()) return Failure{"is not a report: it is no JSON object."};
  const Json& schema = member(json, "schema");
  if (!schema.is_number_integer()) return Failure{"is not a report of the trade: it has no schema."};
  if (schema.get<std::int64_t>() != trade_schema)
    return Failure{text_of("is of schema ", shortened(schema.dump()), "; this program reads ", trade_schema, ".")};
  TradeSummary summary;
  const Json& machine = member(json, "machine");
  summary.renderer = text_in(member(machine, "renderer"));
  summary.cpu = text_in(member(machine, "cpu"));
  summary.timer = text_in(member(machine, "timer"));
  summary.control_ms = spread_in(member(machine, "control_ms"));
  if (member(machine, "size").is_array()) {
    for (const Json& side : member(machine, "size")) summary.size.push_back(number_in(side));
  }
  summary.scene = member(json, "scene").dump();
  summary.cameras = scenes_of(member(json, "cameras"));
  summary.judged_at = number_in(member(json, "judged_at"));
  const Json& settings = member(json, "settings");
  bool all = settings.is_array() && !settings.empty() && makes_sense(summary.control_ms);
  for (const Json& setting : settings) all = add_setting(setting, summary) && all;
  if (!all || summary.control_ms.p10 <= 0.0)
    return Failure{"is not a whole report: times or errors of its settings are missing."};
  return summary;
}

TradeSummary to_be_measured(const SceneDocument& document, const TradePlan& plan) {
  TradeSummary summary;
  summary.size = {static_cast<double>(plan.width), static_cast<double>(plan.height)};
  summary.scene = Json::parse(to_json(document)).dump();
  summary.judged_at = judged_at(document.scene);
  for (const Viewpoint& camera : cameras_for(document.scene, plan))
    summary.cameras += Json::parse(to_json(as_seen_by(document, camera))).dump() + '\n';
  return summary;
}

std::string why_not_comparable(const TradeSummary& before, const TradeSummary& now) {
  if (before.scene != now.scene) return "is of another scene.";
  if (before.judged_at != now.judged_at) return "is of another moment.";
  if (before.size != now.size) return "is of pictures of another size.";
  if (before.cameras != now.cameras) return "is of other cameras.";
  return {};
}

Comparison compare(const TradeSummary& before, const TradeSummary& now) {
  Comparison comparison;
  const bool same = same_machine(before, now);
  const double median = now.control_ms.median / before.control_ms.median;
  const double least = now.control_ms.p10 / before.control_ms.p10;
  comparison.about_times =
      same ? text_of("Work that never changes took ", printed_number(median, 3),
                     " times as long as before (p10: ", printed_number(least, 3), "), and so may every setting.")
           : text_of("Times are not compared: they were measured on another machine (", before.renderer, ", ",
                     before.cpu, ", by the ", before.timer, " clock).");
  for (const auto& [id, setting] : now.settings) {
    const auto found = before.settings.find(id);
    if (found == before.settings.end()) continue;
    ++comparison.compared;
    if (same) compare_times(id, found->second.ms, setting.ms, std::minmax(median, least), comparison);
    compare_errors(id, found->second.psnr, setting.psnr, same ? 0.05 : 0.5, comparison);
  }
  return comparison;
}

}  // namespace terrella
