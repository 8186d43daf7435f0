// What a ground of real size costs for the same error on screen: each way of drawing it, from eye level to far away.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/stats.hpp"
#include "measure/ground_flight.hpp"
#include "measure/node_counts.hpp"
#include "scene/document.hpp"

namespace terrella {

struct GroundPlan {
  int width = 1920, height = 1080;           // pixels of the pictures
  std::vector<double> altitudes;             // m, as of measured_altitudes
  std::vector<double> targets = {1.0, 2.0};  // pixels that 99 of 100 places miss the ground by, at the most
  int frames = 0;                            // timed of each picture; 0: none is drawn
  int flown = 0;                             // frames of a flight to the ground, instead of all this; 0: none
};

// quick: smaller pictures from three altitudes.
GroundPlan ground_plan(bool quick);

// Pixels, over all places that were looked at.
struct ErrorSpread {
  double median = 0.0, p99 = 0.0, most = 0.0;
};

// A ground as a picture of a scene shows it.
struct GroundMeasured {
  int cells = 0;
  double split = 0.0;         // as of NodeRanges
  int places = 0;             // at which errors were measured
  ErrorSpread seen, upright;  // as of NodeError
  NodeCounts ground, sea;
  std::int64_t seen_triangles = 0, coarse_triangles = 0;  // of the ground
  int made = 0;                                           // nodes, also those that are not drawn
  std::int64_t lacking = 0;                               // nodes for which there was no room
  double look_ms = 0.0;                                   // of every frame: to measure how near the ground is
  double choose_ms = 0.0;        // of every frame: to choose nodes, leave out what is not seen, and sort
  double make_ms = 0.0;          // once, from nothing
  std::int64_t allocations = 0;  // of a frame that looks and chooses
};

GroundMeasured measured_ground(const Scene& scene, const View& view);

struct GroundRow {
  std::string scene, model;
  double altitude = 0.0;     // m
  double target = 0.0;       // px
  double pixel_error = 0.0;  // the largest quality.pixel_error by which the target is kept, or the least there is
  GroundMeasured measured;
  std::optional<Spread> frame_ms;  // of whole frames; nothing where none was drawn

  [[nodiscard]] bool reaches_target() const { return measured.seen.p99 <= target; }
};

struct GroundTable {
  GroundPlan plan;
  std::string renderer;  // that frames were drawn by; empty where none were
  double seconds = 0.0;  // that all of it took
  std::vector<GroundRow> rows;
  std::vector<FlightRow> flights{};
};

// Is told what is being measured and which part of all is done, 0..1.
using GroundProgress = std::function<void(const char* what, double part)>;

// documents: at least one, each named by its preset; their planets are of real size. Needs a current context that can
// draw to 32 bit floats where the plan has frames, or any where it has a flight.
GroundTable measure_grounds(const std::vector<SceneDocument>& documents, const GroundPlan& plan,
                            const GroundProgress& progress);

}  // namespace terrella
