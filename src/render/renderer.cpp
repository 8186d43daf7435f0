#include "render/renderer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/check.hpp"
#include "formulas/formulas.hpp"
#include "gl/caps.hpp"
#include "passes/light_target.hpp"
#include "planet/real_size.hpp"
#include "planet/spheres.hpp"
#include "planet/terrain.hpp"
#include "scene/uniforms.hpp"

namespace terrella {
namespace {

constexpr float far_down = -1000.0F;  // planet radii: no bottom is seen through so much water

// Pixels that the planet can cover at the most.
double planet_pixels(const View& view, const Pose& pose) {
  const double all = static_cast<double>(view.width) * view.height;
  const double distance = glm::length(pose.eye);
  if (distance <= 1.0) return all;
  const double radius = 1.0 / (f64::horizon_distance(1.0, distance - 1.0) * pose.pixel_angle);
  return std::isfinite(radius) ? std::min(all, std::numbers::pi * radius * radius) : all;
}

// How often pixels of the planet read a map: the ground its own, water that and the one of its bottom, clouds two
// places of theirs, and what lies under them one more for its shade.
int reads_a_pixel(const Needs& needs, const Scene& scene) {
  const int surface = needs.water != Water::none ? 2 : needs.ground != Ground::none ? 1 : 0;
  // How far land in the mirror is in three places, and its light in four.
  const int mirrored = needs.mirrored_land > 0.0 ? 7 : 0;
  if (needs.clouds == Clouds::none) return surface + mirrored;
  return surface + mirrored + 2 + (surface > 0 && scene.clouds.shadow > 0.0 ? 1 : 0);
}

// To fit a pixel of light to the screen, and to look whether it and its neighbours are an edge.
constexpr int reads_to_show = 1, reads_to_smooth = 5;

// Without water, heights count from the sphere.
Scene scene_as_drawn(Scene scene, const Needs& needs) {
  scene.water.level = water_level(scene);
  if (needs.air == Air::none) scene.air.density = 0.0;
  // A sea of waves has no others.
  if (needs.hides_waves) scene.water.ripples = 0.0;
  return scene;
}

void draw_opaque() {
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glDepthFunc(GL_GREATER);
  glEnable(GL_CULL_FACE);
  glDisable(GL_BLEND);
}

// What is behind shines through by 1 - alpha; colours come weighted.
void draw_veils() {
  glDepthMask(GL_FALSE);
  glDepthFunc(GL_GEQUAL);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

// Before all that has a depth.
void draw_overlays() {
  draw_veils();
  glDisable(GL_DEPTH_TEST);
}

void draw_flat() {
  glDisable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
}

}  // namespace

Renderer::Renderer() : no_ground_(1, gl::Format::rgba16f), no_clouds_(1, gl::Format::rgb10a2) {
  gl::fill(no_ground_, {0.0F, 0.0F, 0.0F, far_down});
  gl::fill(no_clouds_, {0.0F, 0.0F, 0.0F, 0.0F});
}

void Renderer::wait() const {
  if (!light_) return;
  light_->begin();
  float pixel[4];
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, pixel);
}

double Renderer::prepare(const Scene& scene, const View& view, Effort effort) {
  begun_.reset();
  pose_ = pose_of(scene, view);
  needs_ = needs_of(scene, view, pose_);
  choose_techniques(effort);
  if (only_air_) return 1.0;  // two small programs are sooner waited for than asked for again and again
  // The driver compiles meanwhile; to ask it for anything is to wait for it.
  if (ground_) ground_->begin(scene, needs_);
  if (water_ && !has_nodes(needs_.ground)) spheres_.directions(needs_.water_level);
  return ready();
}

void Renderer::choose_techniques(Effort effort) {
  air_.choose(needs_.air);
  // Its program is the smallest; a driver that compiles one after the other is not to begin with the others.
  only_air_ = effort == Effort::soonest && air_;
  if (only_air_) return;
  ground_.choose_made(needs_.ground, [&](Ground technique) { return make_ground(technique, spheres_); });
  water_.choose(needs_.water, needs_.water, spheres_);
  clouds_.choose(needs_.clouds, spheres_);
  stars_.choose(needs_.stars);
  night_.choose(needs_.night);
  sun_.choose(needs_.sun);
  rings_.choose(needs_.rings, spheres_);
  const bool may_fade = has_real_size && needs_.ground == Ground::persistent_grid;
  if (!may_fade) fade_.reset();
  if (may_fade && !fade_) fade_.emplace();
  if (needs_.water == Water::none) {
    backdrop_.reset();
    land_mirror_.reset();
  } else {
    if (!land_mirror_) land_mirror_.emplace();
    // Kept as long as there is water: waves may pass over the lens again and again.
    if (needs_.in_water && !backdrop_) backdrop_.emplace();
  }
  if (ground_) ground_->want(needs_);
  if (water_) water_->want(needs_);
  if (clouds_) clouds_->want(needs_);
}

double Renderer::ready() {
  const bool ready[] = {picture_.ready(), ground_.ready(), water_.ready(),           air_.ready(),
                        clouds_.ready(),  rings_.ready(),  !fade_ || fade_->ready(), !backdrop_ || backdrop_->ready()};
  return static_cast<double>(std::count(std::begin(ready), std::end(ready), true)) / std::size(ready);
}

void Renderer::draw(const Scene& scene, const View& view, const Shot& shot) {
  begin(scene, view, shot);
  draw_rows({0, view.height});
}

void Renderer::begin(const Scene& scene, const View& view, const Shot& shot) {
  pose_ = pose_of(scene, view);
  needs_ = needs_of(scene, view, pose_);
  choose_techniques(shot.effort);
  begun_.emplace(Begun{scene, view, shot, make_sea(scene, view.seconds), {}});
  effort_ = shot.effort;
  planet_box_ = box_of_sphere(pose_, view, outermost_radius(scene));

  gl::begin_frame();
  scene_buffer_.set(gl::block_scene, pack_scene(scene_as_drawn(scene, needs_)));
  update_slots(frame_of({0, view.height}));
  if (ground_ && ground_->is_coarse()) pose_ = pose_over_coarse_ground(scene, view);
  draw_mirror();
  if (water_) water_->mirror_land(needs_, begun_->mirror.has_value());
  begin_light(view, shot);
}

void Renderer::draw_mirror() {
  if (!land_mirror_) return;
  if (needs_.mirrored_land <= 0.0 || !ground_) return land_mirror_->clear();
  const double climb = ground_->mirrored_climb();
  if (climb <= 0.0 || begun_->shot.channel != Channel::color) return;
  begun_->mirror = mirror_of(begun_->scene, pose_, begun_->view);
  begun_->mirror->climb = climb;
  const Mirror& mirror = *begun_->mirror;
  const Frame frame = {begun_->scene, mirror.view,    mirror.pose,      needs_,
                       begun_->sea,   Channel::color, effort_,          {0, mirror.view.height},
                       0.0,           nullptr,        GroundShown::now, &mirror,
                       true};
  set_maps(frame);
  land_mirror_->begin(mirror);
  draw_opaque();
  if (water_) water_->set_waves(frame);
  ground_->draw(frame);
  land_mirror_->end();
}

Frame Renderer::frame_of(const Rows& rows) const {
  CHECK(begun_, rows.first);
  const auto& levels_for = begun_->shot.levels_for;
  return {begun_->scene,
          begun_->view,
          pose_,
          needs_,
          begun_->sea,
          begun_->shot.channel,
          effort_,
          rows,
          begun_->shot.making_ms,
          levels_for ? &*levels_for : nullptr,
          GroundShown::now,
          begun_->mirror ? &*begun_->mirror : nullptr};
}

void Renderer::draw_rows(const Rows& rows) {
  Frame frame = frame_of(rows);
  // Whoever drew in between may have bound their own.
  scene_buffer_.bind(gl::block_scene);
  set_maps(frame);
  const gl::Scissors scissors({0, rows.first, frame.view.width, rows.end - rows.first});
  light_->begin();
  draw_light(frame);
  if (frame.channel != Channel::color) return;
  if (const double part = part_before(); part > 0.0) {
    frame.ground_shown = GroundShown::before;
    fade_->begin(light_->image());
    draw_light(frame);
    fade_->blend(*light_, part);
  }
  picture_.light_changed();
}

double Renderer::part_before() const { return has_real_size && ground_ ? ground_->part_before() : 0.0; }

void Renderer::draw_light(const Frame& frame) {
  draw_opaque();
  if (water_) water_->set_waves(frame);
  const bool in_color = frame.channel == Channel::color;
  const bool has_backdrop = needs_.in_water && in_color;
  if (has_backdrop) backdrop_->draw(frame);
  // The ground first: it costs little where water hides it, and hides the water behind it.
  if (ground_) ground_->draw(frame);
  if (water_) water_->draw(frame, ground_.get());
  if (has_backdrop) backdrop_->close();
  if (in_color) {
    draw_veils();
    if (stars_) stars_->draw(frame);
    if (sun_) sun_->draw_disc(frame);
    if (night_) night_->draw(frame);
    if (rings_) rings_->draw_behind();
    if (air_) air_->draw(frame);
    if (clouds_) clouds_->draw(frame);
    if (rings_) rings_->draw_shadow(frame);
    if (rings_) rings_->draw_before();
    draw_overlays();
    if (sun_ && frame.pose.over_water > 0.0) sun_->draw_glare(frame);
  }
}

bool Renderer::refine(const Scene& scene, const View& view, double making_ms) {
  if (part_before() > 0.0 || (water_ && !water_->settled() && water_->ready())) return true;
  const std::bitset<5> before = settled_slots();
  const Sea sea = make_sea(scene, view.seconds);
  scene_buffer_.set(gl::block_scene, pack_scene(scene_as_drawn(scene, needs_)));
  update_slots({scene, view, pose_, needs_, sea, Channel::color, Effort::live, {0, view.height}, making_ms});
  return settled_slots() != before || part_before() > 0.0;
}

void Renderer::update_slots(const Frame& frame) {
  noise_evaluations_ = 0;
  if (ground_) {
    ground_->update(frame);
    noise_evaluations_ += ground_->noise_evaluations();
  }
  if (clouds_) {
    clouds_->update(frame);
    noise_evaluations_ += clouds_->noise_evaluations();
  }
  if (stars_) {
    stars_->update(frame);
    noise_evaluations_ += stars_->noise_evaluations();
  }
  if (night_) {
    night_->update(frame);
    noise_evaluations_ += night_->noise_evaluations();
  }
  if (sun_) sun_->update(frame);
  const int per_pixel = needs_.pixel_octaves_end - needs_.pixel_octaves_first +
                        (needs_.water == Water::calm ? needs_.ripple_layers : 0) + needs_.cloud_pixel_end -
                        needs_.cloud_pixel_first;
  const double times_drawn = part_before() > 0.0 ? 2.0 : 1.0;
  const double planet = times_drawn * planet_pixels(frame.view, frame.pose);
  // Ground in the mirror has a quarter of the pixels.
  const double in_mirror =
      needs_.mirrored_land > 0.0 ? 0.25 * (needs_.pixel_octaves_end - needs_.pixel_octaves_first) : 0.0;
  noise_evaluations_ += static_cast<std::int64_t>(planet * (per_pixel + in_mirror));
  const double all = static_cast<double>(frame.view.width) * frame.view.height;
  const int smoothing = frame.scene.quality.antialias ? reads_to_smooth : 0;
  texture_reads_ =
      static_cast<std::int64_t>(planet * (reads_a_pixel(needs_, frame.scene) + smoothing) + all * reads_to_show);
}

void Renderer::set_maps(const Frame& frame) {
  Maps maps;
  if (ground_ && ground_->map_texel_angle() > 0.0) {
    maps.ground_texel = ground_->map_texel_angle();
    maps.ground_level = map_level(frame, 1.0, maps.ground_texel);
    ground_->bind_map(maps.ground_level);
  } else {
    no_ground_.bind(gl::unit_ground);
  }
  if (clouds_) {
    maps.cloud_level = map_level(frame, cloud_radius(frame.scene), clouds_->map_texel_angle());
    maps.cloud_moments = clouds_->moments();
    clouds_->bind_map(maps.cloud_level);
  } else {
    no_clouds_.bind(gl::unit_clouds);
  }
  if (land_mirror_ && !frame.is_mirror) land_mirror_->bind();
  const FrameBlock block = frame_block(frame, maps);
  frame_buffer_.set(gl::block_frame, std::as_bytes(std::span(&block, 1)));
}

void Renderer::begin_light(const View& view, const Shot& shot) {
  const gl::Format format =
      shot.full_float && gl::caps().full_float_targets ? gl::Format::rgba32f : gl::Format::rgba16f;
  const float sky = shot.channel == Channel::distance || shot.channel == Channel::height
                        ? std::numeric_limits<float>::infinity()
                        : 0.0F;
  begin_light_target(light_, view.width, view.height, format, sky);
}

void Renderer::show(const gl::Screen& screen, bool antialias) {
  draw_flat();
  picture_.show(light_->image(), screen, antialias ? &planet_box_ : nullptr, effort_ == Effort::complete);
}

bool Renderer::whole() const { return !only_air_ && (!stars_ || stars_->settled()) && picture_.settled(); }

std::bitset<5> Renderer::settled_slots() const {
  std::bitset<5> settled;
  settled[0] = !night_ || night_->settled();
  settled[1] = !sun_ || sun_->settled();
  settled[2] = !ground_ || ground_->settled();
  settled[3] = !clouds_ || clouds_->settled();
  settled[4] = !water_ || water_->settled();
  return settled;
}

bool Renderer::settled() const { return whole() && settled_slots().all(); }

RenderStats Renderer::stats() const {
  RenderStats stats;
  stats.triangles = gl::ledger().triangles;
  stats.draw_calls = gl::ledger().draw_calls;
  stats.noise_evaluations = noise_evaluations_;
  stats.texture_reads = texture_reads_;
  stats.gpu_bytes = gl::ledger().bytes;
  stats.textures = gl::ledger().textures;
  stats.programs = gl::ledger().programs;
  return stats;
}

}  // namespace terrella
