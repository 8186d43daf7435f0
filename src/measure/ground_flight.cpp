#include "measure/ground_flight.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include <glm/common.hpp>

#include "app/stats.hpp"
#include "base/check.hpp"
#include "base/milliseconds.hpp"
#include "measure/ground_models.hpp"
#include "measure/ground_views.hpp"
#include "passes/ground.hpp"
#include "planet/flight.hpp"

namespace terrella {
namespace {

constexpr int times_flown = 3;
constexpr double from_height = 1e7, to_height = 10.0;  // m
constexpr double from_aside = 60.0;                    // degrees of longitude

Flight flight_to_ground(const SceneDocument& document) {
  SceneDocument orbit = document;
  orbit.scene = seen_from(document, from_height);
  Camera from = orbit.scene.camera;
  from.longitude = std::remainder(from.longitude - from_aside, 360.0);
  return {document.scene, from, seen_from(document, to_height).camera};
}

// As a live picture has them made, whose fresh ground is made at rest first.
std::vector<FlightFrame> fly(Scene scene, const Flight& flight, const View& view, int count) {
  SphereMeshes spheres;
  std::unique_ptr<GroundPass> ground;
  std::vector<FlightFrame> frames;
  for (int i = 0; i <= count; ++i) {
    const double part = glm::smoothstep(0.0, 1.0, static_cast<double>(i) / count);
    scene.camera = flight.at(part);
    const auto start = std::chrono::steady_clock::now();
    const Pose pose = pose_of(scene, view);
    const Needs needs = needs_of(scene, view, pose);
    const Sea sea = make_sea(scene, view.seconds);
    if (!ground) ground = make_ground(needs.ground, spheres);
    Frame frame{scene, view, pose, needs, sea, Channel::color, Effort::live, {0, view.height}};
    if (i == 0) frame.effort = Effort::complete;
    ground->update(frame);
    if (i > 0) frames.push_back({pose.clearance * scene.planet.radius, milliseconds_since(start), ground->settled()});
  }
  return frames;
}

}  // namespace

std::vector<FlightFrame> fly_to_ground(const SceneDocument& document, Ground model, const FlightPlan& plan) {
  View view;
  view.width = plan.width;
  view.height = plan.height;
  SceneDocument drawn = document;
  drawn.scene = with_ground(document.scene, model);
  const Flight flight = flight_to_ground(drawn);
  std::vector<FlightFrame> least = fly(drawn.scene, flight, view, plan.frames);
  for (int i = 1; i < times_flown; ++i) {
    const std::vector<FlightFrame> again = fly(drawn.scene, flight, view, plan.frames);
    for (std::size_t n = 0; n < least.size(); ++n) least[n].ms = std::min(least[n].ms, again[n].ms);
  }
  return least;
}

FlightRow flight_row(const std::string& scene, Ground model, const std::vector<FlightFrame>& frames) {
  CHECK(!frames.empty(), scene);
  std::vector<double> times;
  for (const FlightFrame& frame : frames) times.push_back(frame.ms);
  const Spread spread = spread_of(times);
  const auto worst = std::max_element(frames.begin(), frames.end(),
                                      [](const FlightFrame& a, const FlightFrame& b) { return a.ms < b.ms; });
  const auto part_of = [&](const auto& is_so) {
    return static_cast<double>(std::count_if(frames.begin(), frames.end(), is_so)) / static_cast<double>(frames.size());
  };
  FlightRow row;
  row.scene = scene;
  row.model = name_of(model);
  row.median_ms = spread.median;
  row.p90_ms = spread.p90;
  row.worst_ms = worst->ms;
  row.worst_at = worst->clearance;
  row.longer = part_of([&](const FlightFrame& frame) { return frame.ms > 2.0 * spread.median; });
  row.incomplete = part_of([](const FlightFrame& frame) { return !frame.complete; });
  return row;
}

}  // namespace terrella
