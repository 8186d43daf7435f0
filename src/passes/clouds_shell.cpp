#include "passes/clouds_shell.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "formulas/formulas.hpp"
#include "passes/shell.hpp"
#include "planet/cloud_layers.hpp"
#include "planet/spheres.hpp"

namespace terrella {
namespace {

// Noise evaluated in one frame while the maps are behind.
constexpr double noise_a_frame = 900'000.0;

// Every step of time has its own channel, whatever came before it: pictures do not depend on their history.
int channel_of(std::int64_t step) { return static_cast<int>(((step % 3) + 3) % 3); }

// A time, counted in steps: between one of them and the next.
struct Instant {
  std::int64_t step;
  double blend;  // 0..1
};

// interval: between steps, s; 0: time makes no difference.
Instant instant_of(double seconds, double interval) {
  const double time = interval > 0.0 ? seconds / interval : 0.0;
  const double step = std::floor(time);
  return {static_cast<std::int64_t>(step), time - step};
}

// Whether pixels add layers that the map can't hold.
bool shows_fine_layers(const Needs& needs) { return needs.cloud_pixel_end > needs.cloud_pixel_first; }

}  // namespace

CloudsShell::CloudsShell(SphereMeshes& spheres) : spheres_(spheres) {}

void CloudsShell::want(const Needs& needs) {
  draw_program_.want(shows_fine_layers(needs) ? "clouds/shell_near" : "clouds/shell");
}

bool CloudsShell::ready() { return bake_program_.ready() && draw_program_.ready(); }

CloudsShell::Form CloudsShell::form_of(const Scene& scene) {
  const auto& clouds = scene.clouds;
  return {scene.planet.seed, clouds.frequency, clouds.persistence, clouds.warp,
          clouds.swirl,      clouds.belts,     clouds.speed,       clouds.octaves};
}

void CloudsShell::begin_map(const Fineness& fineness) {
  if (shown_ != nullptr && shown_ == fine_.map.get()) former_ = std::exchange(fine_, {});
  if (fine_.map && fine_.map->side() != fineness.texels) fine_.map.reset();
  fine_.fineness = fineness;
  fine_.steps.fill(std::nullopt);
  job_step_.reset();
}

void CloudsShell::update(const Frame& frame) {
  noise_evaluations_ = 0;
  const Form form = form_of(frame.scene);
  const Fineness fineness = {frame.needs.cloud_octaves, frame.needs.cloud_texels, frame.needs.cloud_interval};
  if (form_ != form) {
    form_ = form;
    shown_ = nullptr;
    former_ = {};
    begin_map(fineness);
    set_cyclones(frame.scene);
  } else if (fine_.fineness != fineness) {
    if (former_.map && former_.fineness == fineness) {
      std::swap(fine_, former_);
      job_step_.reset();
    } else {
      begin_map(fineness);
    }
  }

  const Instant now = instant_of(frame.view.seconds, fineness.interval);
  const int all_rows = CubeBake::rows(fineness.texels);
  if (frame.effort == Effort::complete || (fine_.holds(now.step) && job_step_ == now.step + 1)) {
    // What is missing is made at once: all of it, or the rest of the step that time has caught up with.
    while (advance(frame, now.step, fineness.blended(), all_rows)) {
    }
  }
  const std::optional<glm::dvec3> moments = fine_.moments_at(frame.view.seconds);
  if (!moments) return stand_in(frame);
  if (fineness.blended() == 2 && frame.effort == Effort::live) {
    // The next step keeps pace with the blend between these two.
    const auto due = static_cast<int>((now.blend + 0.1) * all_rows);
    const int done = job_step_ == now.step + 2 ? job_.rows_done() : 0;
    if (due > done) advance(frame, now.step, 3, due - done);
  }
  moments_ = *moments;
  shown_ = fine_.map.get();
  former_ = {};
}

void CloudsShell::stand_in(const Frame& frame) {
  // Not in the first frame, which has enough to do.
  const double interval = fine_.fineness.interval;
  if (frame.effort == Effort::live && (coarse_ || former_.map)) {
    const std::int64_t step = instant_of(frame.view.seconds, interval).step;
    advance(frame, step, fine_.fineness.blended(), hasty_rows(frame, interval));
  }
  std::optional<glm::dvec3> moments = former_.moments_at(frame.view.seconds);
  if (!moments) moments = former_.moments_near(frame.view.seconds);
  if (!moments) make_coarse(frame);
  moments_ = moments.value_or(glm::dvec3(1.0, 0.0, 0.0));
  shown_ = moments ? former_.map.get() : coarse_.get();
}

int CloudsShell::hasty_rows(const Frame& frame, double interval) {
  const double elapsed = frame.view.seconds - std::exchange(last_seconds_, frame.view.seconds);
  const double at_ease = noise_a_frame / (static_cast<double>(fine_.fineness.texels) * fine_.fineness.octaves);
  // Where frames are slow, time must still be caught up with: twice as fast as it runs.
  const double pace = interval > 0.0 ? 2.0 * CubeBake::rows(fine_.fineness.texels) * elapsed / interval : 0.0;
  return static_cast<int>(std::clamp(pace, at_ease, 4.0 * at_ease));
}

bool CloudsShell::Map::holds(std::int64_t step) const {
  return steps.at(static_cast<std::size_t>(channel_of(step))) == step;
}

std::optional<glm::dvec3> CloudsShell::Map::moments_at(double seconds) const {
  const Instant instant = instant_of(seconds, fineness.interval);
  const std::int64_t next = instant.step + fineness.blended() - 1;
  if (!holds(instant.step) || !holds(next)) return std::nullopt;
  glm::dvec3 moments(0.0);
  moments[channel_of(instant.step)] += 1.0 - instant.blend;
  moments[channel_of(next)] += instant.blend;
  return moments;
}

std::optional<glm::dvec3> CloudsShell::Map::moments_near(double seconds) const {
  const std::int64_t now = instant_of(seconds, fineness.interval).step;
  std::optional<std::int64_t> nearest;
  for (const auto& step : steps) {
    if (step && (!nearest || std::abs(*step - now) < std::abs(*nearest - now))) nearest = step;
  }
  if (!nearest) return std::nullopt;
  glm::dvec3 moments(0.0);
  moments[channel_of(*nearest)] = 1.0;
  return moments;
}

bool CloudsShell::advance(const Frame& frame, std::int64_t step, int steps, int rows) {
  std::int64_t missing = step;
  while (missing < step + steps && fine_.holds(missing)) ++missing;
  if (missing == step + steps) return false;
  const int channel = channel_of(missing);
  auto& held = fine_.steps.at(static_cast<std::size_t>(channel));
  if (job_step_ != missing) {
    held.reset();
    job_step_ = missing;
    job_.restart();
  }
  if (!fine_.map) fine_.map = std::make_unique<gl::CubeMap>(fine_.fineness.texels, gl::Format::rgb10a2);
  glColorMask(channel == 0, channel == 1, channel == 2, GL_FALSE);
  bake(frame, job_, *fine_.map, static_cast<double>(missing) * fine_.fineness.interval, rows);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  if (job_.done(*fine_.map)) {
    held = missing;
    job_step_.reset();
  }
  return true;
}

void CloudsShell::make_coarse(const Frame& frame) {
  if (!coarse_) coarse_ = std::make_unique<gl::CubeMap>(coarse_cloud_texels, gl::Format::rgb10a2);
  coarse_bake_.restart();
  bake(frame, coarse_bake_, *coarse_, frame.view.seconds, CubeBake::rows(coarse_cloud_texels));
}

void CloudsShell::bake(const Frame& frame, CubeBake& bake, gl::CubeMap& map, double seconds, int rows) {
  const int octaves = frame.needs.cloud_octaves;
  bake_program_.use();
  bake_program_.set("octaves", octaves);
  std::array<glm::vec2, 12> turns{};
  for (int i = 0; i < octaves; ++i) {
    turns.at(static_cast<std::size_t>(i)) = glm::vec2(turn_of_cloud_layer(frame.scene, i, seconds));
  }
  for (std::size_t i = 0; i < turns.size(); i += 2) {
    const std::string name = "turns[" + std::to_string(i / 2) + "]";
    bake_program_.set(name.c_str(), turns[i].x, turns[i].y, turns[i + 1].x, turns[i + 1].y);
  }
  noise_evaluations_ += bake.advance(bake_program_, map, rows) * octaves;
}

void CloudsShell::set_cyclones(const Scene& scene) {
  const Cyclones cyclones = cyclones_of(scene);
  bake_program_.use();
  bake_program_.set("cyclones", cyclones.count);
  for (int i = 0; i < cyclones.count; ++i) {
    const std::string name = "cyclone[" + std::to_string(i) + "]";
    const glm::vec4 place(cyclones.places.at(static_cast<std::size_t>(i)));
    bake_program_.set(name.c_str(), place.x, place.y, place.z, place.w);
  }
}

void CloudsShell::bind_map(double level) { shown_->bind(gl::unit_clouds, level); }

void CloudsShell::draw(const Frame& frame) {
  gl::Program& program = draw_program_.use(frame.effort == Effort::complete);
  if (shows_fine_layers(frame.needs)) {
    const glm::vec2 turn(turn_of_cloud_layer(frame.scene, f64::stirring_layers, frame.view.seconds));
    program.set("layers", static_cast<float>(frame.needs.cloud_pixel_first),
                static_cast<float>(frame.needs.cloud_pixel_end), static_cast<float>(map_texel_angle()),
                static_cast<float>(frame.scene.quality.cloud_texel_size));
    program.set("turn", turn.x, turn.y);
  }
  draw_shell(spheres_, program, frame, frame.needs.cloud_level, cloud_radius(frame.scene));
}

}  // namespace terrella
