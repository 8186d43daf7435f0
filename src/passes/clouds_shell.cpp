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

// Whether pixels add layers that the map can't hold.
bool shows_fine_layers(const Needs& needs) { return needs.cloud_pixel_end > needs.cloud_pixel_first; }

}  // namespace

CloudsShell::CloudsShell(SphereMeshes& spheres) : spheres_(spheres) {}

void CloudsShell::want(const Needs& needs) {
  draw_program_.want(shows_fine_layers(needs) ? "clouds/shell_near" : "clouds/shell");
}

bool CloudsShell::ready() { return bake_program_.ready() && draw_program_.ready(); }

void CloudsShell::update(const Frame& frame) {
  noise_evaluations_ = 0;
  const auto& clouds = frame.scene.clouds;
  const Key key = {frame.scene.planet.seed,
                   clouds.frequency,
                   clouds.persistence,
                   clouds.warp,
                   clouds.swirl,
                   clouds.belts,
                   clouds.speed,
                   clouds.octaves,
                   frame.needs.cloud_octaves,
                   frame.needs.cloud_texels};
  if (!key_ || *key_ != key) {
    key_ = key;
    steps_.fill(std::nullopt);
    job_step_.reset();
    if (fine_ && fine_->side() != key.texels) fine_.reset();
    set_cyclones(frame.scene);
  }

  const double interval = frame.needs.cloud_interval;
  const double time = interval > 0.0 ? frame.view.seconds / interval : 0.0;
  const auto step = static_cast<std::int64_t>(std::floor(time));
  const double blend = time - static_cast<double>(step);
  const int pair = interval > 0.0 ? 2 : 1;
  const int all_rows = CubeBake::rows(key.texels);

  if (frame.effort == Effort::complete || (holds(step) && job_step_ == step + 1)) {
    // What is missing is made at once: all of it, or the rest of the step that time has caught up with.
    while (advance(frame, step, pair, all_rows)) {
    }
  }
  coarse_in_use_ = !holds(step) || !holds(step + pair - 1);
  if (coarse_in_use_) {
    // Not in the first frame, which has enough to do.
    if (frame.effort == Effort::live && coarse_) advance(frame, step, pair, hasty_rows(frame, interval));
    make_coarse(frame);
    moments_ = {1.0, 0.0, 0.0};
    return;
  }
  if (pair == 2 && frame.effort == Effort::live) {
    // The next step keeps pace with the blend between these two.
    const auto due = static_cast<int>((blend + 0.1) * all_rows);
    const int done = job_step_ == step + 2 ? job_.rows_done() : 0;
    if (due > done) advance(frame, step, 3, due - done);
  }
  moments_ = glm::dvec3(0.0);
  moments_[channel_of(step)] += 1.0 - blend;
  moments_[channel_of(step + pair - 1)] += blend;
}

int CloudsShell::hasty_rows(const Frame& frame, double interval) {
  const double elapsed = frame.view.seconds - std::exchange(last_seconds_, frame.view.seconds);
  const double at_ease = noise_a_frame / (static_cast<double>(key_->texels) * key_->map_octaves);
  // Where frames are slow, time must still be caught up with: twice as fast as it runs.
  const double pace = interval > 0.0 ? 2.0 * CubeBake::rows(key_->texels) * elapsed / interval : 0.0;
  return static_cast<int>(std::clamp(pace, at_ease, 4.0 * at_ease));
}

bool CloudsShell::holds(std::int64_t step) const {
  return steps_.at(static_cast<std::size_t>(channel_of(step))) == step;
}

bool CloudsShell::advance(const Frame& frame, std::int64_t step, int steps, int rows) {
  std::int64_t missing = step;
  while (missing < step + steps && holds(missing)) ++missing;
  if (missing == step + steps) return false;
  const int channel = channel_of(missing);
  auto& held = steps_.at(static_cast<std::size_t>(channel));
  if (job_step_ != missing) {
    held.reset();
    job_step_ = missing;
    job_.restart();
  }
  if (!fine_) fine_ = std::make_unique<gl::CubeMap>(key_->texels, gl::Format::rgb10a2);
  glColorMask(channel == 0, channel == 1, channel == 2, GL_FALSE);
  bake(frame, job_, *fine_, static_cast<double>(missing) * frame.needs.cloud_interval, rows);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  if (job_.done(*fine_)) {
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

void CloudsShell::bind_map(double level) { (coarse_in_use_ ? coarse_ : fine_)->bind(gl::unit_clouds, level); }

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
