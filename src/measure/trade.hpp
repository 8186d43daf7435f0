// The trade of speed for accuracy: what each setting of the knobs costs and how far its pictures are from the truth.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/stats.hpp"
#include "measure/cameras.hpp"
#include "measure/effects.hpp"
#include "measure/knobs.hpp"
#include "measure/picture_error.hpp"
#include "measure/quality_presets.hpp"
#include "scene/document.hpp"

namespace terrella {

// How much is measured.
struct TradePlan {
  int width = 480, height = 270;  // pixels of all pictures, >= 1
  int rounds = 5;                 // in each of which every setting is timed; >= 1
  bool few = false;               // only three values of each knob, and two cameras
  bool path_only = false;         // only the scene's own setting and the steps of quality_path()
  Truth::Goal truth = {45.0, 54};
};

// The plan for a scene of common cost on two cores without a GPU: a few minutes, or quick, under one.
TradePlan trade_plan(bool quick);

// From where a plan looks at a scene.
std::vector<Viewpoint> cameras_for(const Scene& scene, const TradePlan& plan);

// Where it was measured.
struct Machine {
  std::string renderer, gl_version, cpu;
  int cores = 0;
  bool gpu_timer = false;  // else times are by the clock on the wall
  Spread control_ms;       // of work that never changes
};

// A setting as one camera sees it.
struct Sighting {
  std::vector<double> times;   // ms of single frames, round by round
  std::vector<double> beside;  // of frames of the scene itself that were taken next to these; of effects only
  std::vector<double> work;    // as counters() has it
  PictureError error;
  Image picture, errors;  // small; errors: 1 channel, FLIP
};

struct Setting {
  std::string id;  // as of setting_id
  Scene scene;
  std::vector<Sighting> sightings;  // by camera

  // Over all cameras.
  [[nodiscard]] Spread ms() const;
  [[nodiscard]] PictureError error() const;
  [[nodiscard]] std::vector<double> work() const;
  [[nodiscard]] Offer offer() const;
};

// A setting that was only tried: by a few frames, and without what no way leads to.
struct Estimate {
  std::string id;
  Offer offer;
};

struct KnobTrade {
  const Knob* knob;
  std::vector<Value> values;          // from the cheapest to the most accurate
  std::vector<std::size_t> settings;  // which they are, by number, all other knobs being as the scene has them
};

// The scene without an effect, beside the scene.
struct EffectTrade {
  const Effect* effect;
  Setting without;
  Spread cost_ms;  // what it adds to a frame: of the differences of frames taken next to each other
};

struct CameraTruth {
  Viewpoint camera;
  double self_psnr;  // as of Truth
  int samples;
  Image picture;  // small
};

struct TradeReport {
  SceneDocument document;
  TradePlan plan;
  Machine machine;
  double seconds = 0.0;  // that all of it took
  std::vector<CameraTruth> cameras;
  std::vector<Setting> settings;  // all that were timed by turns
  std::size_t own = 0;            // which of them the scene has
  std::vector<Estimate> estimates;
  std::vector<KnobTrade> knobs;
  std::vector<std::size_t> front, path;  // by number: the front, and what is left of it where each step is noticed
  std::vector<QualityPreset> presets;
  std::vector<std::size_t> steps;  // by number: those of quality_path(), as far as they were measured
  std::vector<EffectTrade> effects;
};

// Each step of the path takes so many times as long as the one before.
inline constexpr double noticed_step = 1.1;

// Is told what is being done and which part of it is done, 0..1.
using TradeProgress = std::function<void(const char* what, double part)>;

// Needs a current context that can draw to 32 bit floats.
TradeReport measure_trade(const SceneDocument& document, const TradePlan& plan, const TradeProgress& progress);

// Fills in what follows from the settings: front, path and presets.
void draw_conclusions(TradeReport& report);

}  // namespace terrella
