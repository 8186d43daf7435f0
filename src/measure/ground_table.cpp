#include "measure/ground_table.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <tuple>

#include "base/milliseconds.hpp"
#include "gl/caps.hpp"
#include "measure/allocations.hpp"
#include "measure/ground_models.hpp"
#include "measure/ground_views.hpp"
#include "measure/node_errors.hpp"
#include "measure/subject.hpp"
#include "scene/parameters.hpp"

namespace terrella {
namespace {

constexpr int places_looked_at = 20'000;

ErrorSpread spread_of_errors(const std::vector<NodeError>& errors, double NodeError::*of) {
  if (errors.empty()) return {};
  return {percentile(errors, of, 0.5), percentile(errors, of, 0.99), percentile(errors, of, 1.0)};
}

// Median, ms.
double time_of(const std::function<void()>& work) {
  constexpr int repeats = 31;
  std::vector<double> times;
  for (int i = 0; i < repeats; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work();
    times.push_back(milliseconds_since(start));
  }
  return spread_of(times).median;
}

// Pictures of one scene by one model, which differ in quality.pixel_error. Only some values of that make another
// ground.
class Search {
 public:
  Search(const Scene& scene, const View& view) : scene_(scene), view_(view) {}

  // The largest pixel_error by which 99 of 100 places miss the ground by no more than the target, or the least there
  // is.
  double pixel_error_for(double target) {
    constexpr int steps = 8;
    const Parameter& parameter = *find_parameter("quality.pixel_error");
    double low = parameter.min, high = parameter.max;
    if (reaches(target, high)) return high;
    for (int i = 0; i < steps; ++i) {
      const double middle = std::sqrt(low * high);
      (reaches(target, middle) ? low : high) = middle;
    }
    return low;
  }

  const GroundMeasured& measured(double pixel_error) {
    const Scene scene = with(pixel_error);
    const Needs needs = needs_of(scene, view_, pose_of(scene, view_));
    const Fineness fineness = {needs.ground_cells, needs.ground_split};
    const auto known = known_.find(fineness);
    if (known != known_.end()) return known->second;
    return known_[fineness] = measured_ground(scene, view_);
  }

  [[nodiscard]] Scene with(double pixel_error) const {
    Scene scene = scene_;
    scene.quality.pixel_error = pixel_error;
    return scene;
  }

 private:
  using Fineness = std::pair<int, double>;

  bool reaches(double target, double pixel_error) { return measured(pixel_error).seen.p99 <= target; }

  Scene scene_;
  View view_;
  std::map<Fineness, GroundMeasured> known_;
};

Spread time_frames(Subject& subject, const Scene& scene, int frames) {
  Stopwatch stopwatch;
  subject.pose(scene);
  std::vector<double> times;
  for (int i = 0; i < frames; ++i) times.push_back(subject.frame(stopwatch));
  return spread_of(times);
}

// One for each target. subject: draws frames; null: none are drawn.
void add_rows(const SceneDocument& document, double altitude, Ground model, Subject* subject, GroundTable& table) {
  View view;
  view.width = table.plan.width;
  view.height = table.plan.height;
  Search search(with_ground(seen_from(document, altitude), model), view);
  for (const double target : table.plan.targets) {
    GroundRow row;
    row.scene = document.preset;
    row.model = name_of(model);
    row.altitude = altitude;
    row.target = target;
    row.pixel_error = search.pixel_error_for(target);
    row.measured = search.measured(row.pixel_error);
    if (subject != nullptr) row.frame_ms = time_frames(*subject, search.with(row.pixel_error), table.plan.frames);
    table.rows.push_back(row);
  }
}

void fly(const std::vector<SceneDocument>& documents, const GroundProgress& progress, GroundTable& table) {
  const double all = static_cast<double>(documents.size() * ground_models().size());
  double done = 0.0;
  for (const SceneDocument& document : documents) {
    for (const Ground model : ground_models()) {
      progress(document.preset.c_str(), done++ / all);
      table.flights.push_back(
          flight_row(document.preset, model,
                     fly_to_ground(document, model, {table.plan.width, table.plan.height, table.plan.flown})));
    }
  }
}

void look(const std::vector<SceneDocument>& documents, const GroundProgress& progress, GroundTable& table) {
  std::unique_ptr<Subject> subject;
  if (table.plan.frames > 0) {
    subject = std::make_unique<Subject>(table.plan.width, table.plan.height);
    table.renderer = gl::renderer_name();
  }
  const double all = static_cast<double>(documents.size() * table.plan.altitudes.size() * ground_models().size());
  double done = 0.0;
  for (const SceneDocument& document : documents) {
    for (const double altitude : table.plan.altitudes) {
      for (const Ground model : ground_models()) {
        progress(document.preset.c_str(), done++ / all);
        add_rows(document, altitude, model, subject.get(), table);
      }
    }
  }
}

}  // namespace

GroundPlan ground_plan(bool quick) {
  GroundPlan plan;
  plan.altitudes.assign(measured_altitudes().begin(), measured_altitudes().end());
  if (!quick) return plan;
  plan.width = 480;
  plan.height = 270;
  plan.altitudes = {10.0, 1e4, 1e7};
  return plan;
}

GroundMeasured measured_ground(const Scene& scene, const View& view) {
  NodePicture picture(scene, view);
  GroundMeasured measured;
  measured.cells = picture.needs().ground_cells;
  measured.split = picture.ranges().split;
  const std::vector<NodeError> errors = node_errors(picture, places_looked_at, footprint_of_pixel(scene));
  measured.places = static_cast<int>(errors.size());
  measured.seen = spread_of_errors(errors, &NodeError::seen);
  measured.upright = spread_of_errors(errors, &NodeError::upright);
  measured.ground = node_counts(picture, NodeLayer::ground);
  measured.sea = node_counts(picture, NodeLayer::sea) + node_counts(picture, NodeLayer::deep_sea);
  measured.seen_triangles = seen_triangles(picture);
  measured.coarse_triangles = coarse_triangles(picture);
  measured.made = picture.made();
  measured.lacking = static_cast<std::int64_t>(picture.missing());
  measured.make_ms = picture.making_ms();
  measured.look_ms = time_of([&] { picture.look(); });
  measured.choose_ms = time_of([&] { picture.choose(); });
  const std::int64_t before = allocations();
  picture.look();
  picture.choose();
  measured.allocations = allocations() - before;
  return measured;
}

GroundTable measure_grounds(const std::vector<SceneDocument>& documents, const GroundPlan& plan,
                            const GroundProgress& progress) {
  const auto start = std::chrono::steady_clock::now();
  GroundTable table;
  table.plan = plan;
  plan.flown > 0 ? fly(documents, progress, table) : look(documents, progress, table);
  progress("grounds", 1.0);
  table.seconds = 1e-3 * milliseconds_since(start);
  return table;
}

}  // namespace terrella
