#include "measure/trade_json.hpp"

#include <nlohmann/json.hpp>

#include "measure/counters.hpp"
#include "measure/image_error.hpp"
#include "measure/moment.hpp"
#include "scene/json.hpp"

namespace terrella {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Spread& spread) { return {{"median", spread.median}, {"p10", spread.p10}, {"p90", spread.p90}}; }

Json json_of(const Value& value) { return Json::parse(json_value(value)); }

// Adds what tells how far pictures are off.
void add(Json& to, const PictureError& error) {
  to["psnr"] = error.psnr();
  to["flip"] = error.flip;
  to["visible"] = error.visible;
  to["silhouette_px"] = error.silhouette;
  to["normal_deg"] = {{"median", error.normal_median}, {"p99", error.normal_p99}};
}

void add_work(Json& to, const std::vector<double>& work) {
  for (std::size_t i = 0; i < work.size(); ++i) to["work"][counters()[i].name] = work[i];
}

Json json_of(const Setting& setting, const TradeReport& report) {
  Json json;
  json["id"] = setting.id;
  for (const Knob& knob : knobs()) {
    if (knob.matters(report.document.scene))
      json["parameters"][std::string(knob.path)] = json_of(parameter_of(knob).get(setting.scene));
  }
  json["ms"] = json_of(setting.ms());
  add(json, setting.error());
  add_work(json, setting.work());
  for (std::size_t c = 0; c < setting.sightings.size(); ++c) {
    const Sighting& sighting = setting.sightings[c];
    Json seen;
    seen["camera"] = report.cameras[c].camera.name;
    seen["ms"] = json_of(spread_of(sighting.times));
    add(seen, sighting.error);
    add_work(seen, sighting.work);
    json["cameras"].push_back(seen);
  }
  return json;
}

Json machine_json(const TradeReport& report) {
  const Machine& machine = report.machine;
  return {{"renderer", machine.renderer},
          {"gl_version", machine.gl_version},
          {"cpu", machine.cpu},
          {"cores", machine.cores},
          {"size", {report.plan.width, report.plan.height}},
          {"timer", machine.gpu_timer ? "gpu" : "wall"},
          {"control_ms", json_of(machine.control_ms)}};
}

Json cameras_json(const TradeReport& report) {
  Json cameras = Json::array();
  for (const CameraTruth& truth : report.cameras) {
    cameras.push_back({{"name", truth.camera.name},
                       {"what", truth.camera.what},
                       {"scene", Json::parse(to_json(as_seen_by(report.document, truth.camera)))},
                       {"reference", {{"samples", truth.samples}, {"self_psnr", truth.self_psnr}}}});
  }
  return cameras;
}

Json knobs_json(const TradeReport& report) {
  Json knobs = Json::array();
  for (const KnobTrade& trade : report.knobs) {
    Json values = Json::array();
    for (std::size_t i = 0; i < trade.values.size(); ++i)
      values.push_back({{"value", json_of(trade.values[i])}, {"setting", report.settings[trade.settings[i]].id}});
    knobs.push_back({{"path", trade.knob->path}, {"values", values}});
  }
  return knobs;
}

Json ids_json(const std::vector<std::size_t>& numbers, const TradeReport& report) {
  Json ids = Json::array();
  for (const std::size_t i : numbers) ids.push_back(report.settings[i].id);
  return ids;
}

Json presets_json(const TradeReport& report) {
  Json presets = Json::array();
  for (const QualityPreset& preset : report.presets) {
    const Setting& setting = report.settings[preset.setting];
    Json json = {
        {"name", preset.name}, {"setting", setting.id}, {"ms", setting.ms().median}, {"psnr", setting.error().psnr()}};
    json["target_psnr"] = preset.target > 0.0 ? Json(preset.target) : Json();
    json["reached"] = preset.reached;
    presets.push_back(json);
  }
  return presets;
}

Json effects_json(const TradeReport& report) {
  Json effects = Json::array();
  const PictureError with = report.settings[report.own].error();
  for (const EffectTrade& trade : report.effects) {
    const PictureError without = trade.without.error();
    effects.push_back({{"name", trade.effect->name},
                       {"cost_ms", json_of(trade.cost_ms)},
                       {"psnr_without", without.psnr()},
                       {"psnr_lost", with.psnr() - without.psnr()},
                       {"flip_without", without.flip},
                       {"flip_added", without.flip - with.flip},
                       {"visible_added", without.visible - with.visible}});
  }
  return effects;
}

}  // namespace

SceneDocument as_seen_by(SceneDocument document, const Viewpoint& camera) {
  document.scene = seen_by(document.scene, camera);
  return document;
}

std::string trade_json(const TradeReport& report) {
  Json json;
  json["schema"] = trade_schema;
  json["machine"] = machine_json(report);
  json["seconds"] = report.seconds;
  json["judged_at"] = judged_at(report.document.scene);
  json["rounds"] = report.plan.rounds;
  json["scene"] = Json::parse(to_json(report.document));
  json["cameras"] = cameras_json(report);
  json["knobs"] = knobs_json(report);
  json["own"] = report.settings[report.own].id;
  json["settings"] = Json::array();
  for (const Setting& setting : report.settings) json["settings"].push_back(json_of(setting, report));
  json["tried"] = Json::array();
  for (const Estimate& estimate : report.estimates)
    json["tried"].push_back(
        {{"id", estimate.id}, {"ms", estimate.offer.ms}, {"psnr", psnr_of(estimate.offer.mean_square)}});
  json["front"] = ids_json(report.front, report);
  json["path"] = ids_json(report.path, report);
  json["presets"] = presets_json(report);
  json["steps"] = ids_json(report.steps, report);
  json["effects"] = effects_json(report);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace terrella
