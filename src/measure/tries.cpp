#include "measure/tries.hpp"

#include <algorithm>

#include "measure/subject.hpp"
#include "measure/walk.hpp"

namespace terrella {
namespace {

constexpr int frames = 3, most_frames = 12;
constexpr double enough_ms = 60.0;  // of frames that take little: they are disturbed by as much as others

// The least time of a few frames: it is the least disturbed.
double quick_ms(Subject& subject, Stopwatch& stopwatch) {
  subject.frame(stopwatch);
  double least = subject.frame(stopwatch), all = least;
  for (int i = 1; i < frames || (i < most_frames && all < enough_ms); ++i) {
    const double ms = subject.frame(stopwatch);
    least = std::min(least, ms);
    all += ms;
  }
  return least;
}

Offer quick_offer(Subject& subject, Stopwatch& stopwatch, const Scene& scene, const std::vector<Viewpoint>& cameras,
                  const std::vector<Truth>& truths) {
  Offer offer;
  const double share = 1.0 / static_cast<double>(cameras.size());
  for (std::size_t c = 0; c < cameras.size(); ++c) {
    const Image picture = subject.pose(seen_by(scene, cameras[c]));
    offer.mean_square += share * truths[c].mean_square_error_of(picture);
    offer.ms += share * quick_ms(subject, stopwatch);
  }
  return offer;
}

}  // namespace

std::vector<Estimate> try_settings(const Scene& scene, const std::vector<KnobTrade>& knobs,
                                   const std::vector<Viewpoint>& cameras, const std::vector<Truth>& truths,
                                   const TradePlan& plan, const std::function<void(double part)>& progress,
                                   std::vector<Scene>& scenes) {
  Subject subject(plan.width, plan.height);
  Stopwatch stopwatch;
  std::vector<int> counts;
  int all_steps = 0;
  for (const KnobTrade& knob : knobs) {
    counts.push_back(static_cast<int>(knob.values.size()));
    all_steps += counts.back() - 1;
  }
  std::vector<Estimate> estimates;
  walk_up(counts, [&](const Levels& levels) {
    Scene tried = scene;
    int steps = 0;
    for (std::size_t k = 0; k < knobs.size(); ++k) {
      tried = turned(tried, *knobs[k].knob, knobs[k].values[static_cast<std::size_t>(levels[k])]);
      steps += levels[k];
    }
    scenes.push_back(tried);
    estimates.push_back({setting_id(tried), quick_offer(subject, stopwatch, tried, cameras, truths)});
    progress(static_cast<double>(steps) / all_steps);
    return estimates.back().offer;
  });
  progress(1.0);
  return estimates;
}

}  // namespace terrella
