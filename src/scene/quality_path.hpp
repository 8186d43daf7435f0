#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "base/issues.hpp"
#include "scene/scene.hpp"

namespace terrella {

// Settings of the group quality that are worth their time: each is more accurate than all that are as cheap.
struct QualityStep {
  std::string_view preset;  // "fast", "balanced", "high" or "reference", where a step has that name; else empty
  double cost;              // time of a frame, as a multiple of the first step's: > 1 but for that one
  double psnr;              // dB of pictures of the default scene against the reference
  double visible;           // part of their pixels that are off by a difference one can see, 0..1
  decltype(Scene::quality) quality;
};

// From the cheapest to the most accurate, as measured (quality_path.inc); two or more.
std::span<const QualityStep> quality_path();

// The step of that name; null if there is none.
const QualityStep* find_quality(std::string_view preset);

// The names of all that have one, in the order of the path.
std::vector<std::string_view> quality_names();

// "quality: "fats" is not a preset of quality; allowed are fast, reference; did you mean fast?"
Issue no_such_quality(std::string_view preset);

// Whether steps take the place of the scene's own settings, to hold quality.target_ms.
inline bool holds_time(const Scene& scene) { return scene.quality.target_ms > 0.0; }

// The scene with the settings of a step, but for quality.target_ms, which is no matter of accuracy.
Scene with_quality(Scene scene, const QualityStep& step);

// Whether it has them.
bool has_quality(const Scene& scene, const QualityStep& step);

}  // namespace terrella
