#include "measure/trade.hpp"

#include <algorithm>
#include <chrono>
#include <iterator>

#include "measure/counters.hpp"
#include "measure/machine.hpp"
#include "measure/thumbnail.hpp"
#include "measure/tries.hpp"
#include "measure/turns.hpp"
#include "scene/quality_path.hpp"

namespace terrella {
namespace {

// Estimates of times may be off by so much of them.
constexpr double estimates_may_be_off = 0.08;
// Errors that differ by less, 0.09 dB, are not worth a setting of their own.
constexpr double slight_error = 0.02;

// The scenes that are timed, each once.
class Chosen {
 public:
  // Returns which it is.
  std::size_t add(const Scene& scene) {
    const auto found = std::find(scenes_.begin(), scenes_.end(), scene);
    if (found != scenes_.end()) return static_cast<std::size_t>(found - scenes_.begin());
    scenes_.push_back(scene);
    return scenes_.size() - 1;
  }
  [[nodiscard]] const std::vector<Scene>& scenes() const { return scenes_; }

 private:
  std::vector<Scene> scenes_;
};

std::vector<KnobTrade> knobs_for(const Scene& scene, bool few) {
  std::vector<KnobTrade> trades;
  for (const Knob& knob : knobs()) {
    if (knob.matters(scene)) trades.push_back({&knob, values_for(knob, scene, few), {}});
  }
  return trades;
}

std::vector<Truth> truths_of(const Scene& scene, const std::vector<Viewpoint>& cameras, const TradePlan& plan,
                             const TradeProgress& progress) {
  std::vector<Truth> truths;
  for (const Viewpoint& camera : cameras) {
    const double before = static_cast<double>(truths.size());
    const auto told = [&](double part) {
      progress("drawing the truth", (before + part) / static_cast<double>(cameras.size()));
    };
    truths.emplace_back(seen_by(scene, camera), plan.width, plan.height, plan.truth, told);
  }
  return truths;
}

// By what a frame of the scene takes longer than one without an effect, over all cameras.
Spread cost_of(const Setting& without) {
  std::vector<double> differences(without.sightings.front().times.size(), 0.0);
  const double share = 1.0 / static_cast<double>(without.sightings.size());
  for (const Sighting& sighting : without.sightings) {
    for (std::size_t i = 0; i < differences.size(); ++i)
      differences[i] += share * (sighting.beside[i] - sighting.times[i]);
  }
  return spread_of(std::move(differences));
}

// What of the settings that were tried may be on the front, and both ends of the walk.
void add_promising(Chosen& chosen, const std::vector<Estimate>& estimates, const std::vector<Scene>& tried) {
  std::vector<Offer> offers;
  for (const Estimate& estimate : estimates) offers.push_back(estimate.offer);
  for (const std::size_t i : nearly_on_front(offers, estimates_may_be_off, slight_error)) chosen.add(tried[i]);
  chosen.add(tried.front());
  chosen.add(tried.back());
}

// All scenes of the report: settings first, then the scene without each of its effects.
std::vector<Timed> choose_scenes(TradeReport& report, const std::vector<Scene>& tried) {
  Chosen chosen;
  const Scene& scene = report.document.scene;
  report.own = chosen.add(scene);
  for (KnobTrade& trade : report.knobs) {
    for (const Value& value : trade.values) trade.settings.push_back(chosen.add(turned(scene, *trade.knob, value)));
  }
  if (report.plan.path_only) {
    for (const QualityStep& step : quality_path()) report.steps.push_back(chosen.add(with_quality(scene, step)));
  } else {
    add_promising(chosen, report.estimates, tried);
  }
  std::vector<Timed> scenes;
  for (const Scene& one : chosen.scenes()) {
    report.settings.push_back({setting_id(one), one, {}});
    scenes.push_back({one, std::nullopt});
  }
  for (const Effect& effect : effects()) {
    if (!has(scene, effect)) continue;
    Scene without = scene;
    effect.leave_out(without);
    scenes.push_back({without, report.own});
    report.effects.push_back({&effect, {effect.name, without, {}}, {}});
  }
  return scenes;
}

void hand_out(Turns turns, TradeReport& report) {
  const std::size_t count = report.settings.size();
  for (std::size_t i = 0; i < count; ++i) report.settings[i].sightings = std::move(turns.sightings[i]);
  for (std::size_t i = 0; i < report.effects.size(); ++i) {
    EffectTrade& trade = report.effects[i];
    trade.without.sightings = std::move(turns.sightings[count + i]);
    trade.cost_ms = cost_of(trade.without);
  }
  report.machine.control_ms = spread_of(std::move(turns.control_ms));
  report.machine.gpu_timer = turns.gpu_timer;
}

}  // namespace

TradePlan trade_plan(bool quick) {
  TradePlan plan;
  if (quick) {
    plan.width = 160;
    plan.height = 90;
    plan.rounds = 3;
    plan.few = true;
    plan.truth = {40.0, 13};
  }
  return plan;
}

std::vector<Viewpoint> cameras_for(const Scene& scene, const TradePlan& plan) {
  std::vector<Viewpoint> cameras = cameras_of(scene);
  if (plan.few) cameras.erase(cameras.begin() + 2, cameras.end());
  return cameras;
}

Spread Setting::ms() const {
  std::vector<double> means(sightings.front().times.size(), 0.0);
  for (const Sighting& sighting : sightings) {
    for (std::size_t i = 0; i < means.size(); ++i)
      means[i] += sighting.times[i] / static_cast<double>(sightings.size());
  }
  return spread_of(std::move(means));
}

PictureError Setting::error() const {
  std::vector<PictureError> errors;
  for (const Sighting& sighting : sightings) errors.push_back(sighting.error);
  return mean_of(errors);
}

std::vector<double> Setting::work() const {
  std::vector<double> mean(counters().size(), 0.0);
  for (const Sighting& sighting : sightings) {
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += sighting.work[i] / static_cast<double>(sightings.size());
  }
  return mean;
}

Offer Setting::offer() const { return {ms().median, error().mean_square}; }

void draw_conclusions(TradeReport& report) {
  std::vector<Offer> offers;
  for (const Setting& setting : report.settings) offers.push_back(setting.offer());
  report.front = front_of(offers);
  report.path = thinned(offers, report.front, noticed_step);
  report.presets = quality_presets(offers, report.front);
}

TradeReport measure_trade(const SceneDocument& document, const TradePlan& plan, const TradeProgress& progress) {
  const auto start = std::chrono::steady_clock::now();
  TradeReport report;
  report.document = document;
  report.plan = plan;
  report.machine = this_machine();
  if (!plan.path_only) report.knobs = knobs_for(document.scene, plan.few);
  const std::vector<Viewpoint> cameras = cameras_for(document.scene, plan);
  std::vector<Truth> truths = truths_of(document.scene, cameras, plan, progress);
  for (std::size_t c = 0; c < cameras.size(); ++c) {
    report.cameras.push_back({cameras[c], truths[c].self_psnr(), truths[c].samples(), thumbnail(truths[c].picture())});
  }
  std::vector<Scene> tried;
  if (!plan.path_only) {
    report.estimates = try_settings(
        document.scene, report.knobs, cameras, truths, plan, [&](double part) { progress("trying settings", part); },
        tried);
  }
  const std::vector<Timed> scenes = choose_scenes(report, tried);
  hand_out(take_turns(scenes, cameras, truths, plan, [&](double part) { progress("timing by turns", part); }), report);
  draw_conclusions(report);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace terrella
