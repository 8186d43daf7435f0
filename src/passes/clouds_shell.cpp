#include "passes/clouds_shell.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace terrella {
namespace {

// Noise evaluated in one frame while the maps are behind.
constexpr std::int64_t noise_a_frame = 900'000;

}  // namespace

CloudsShell::CloudsShell(SphereMeshes& spheres) : spheres_(spheres) {}

bool CloudsShell::ready() { return bake_program_.ready() && draw_program_.ready(); }

void CloudsShell::update(const Frame& frame) {
  noise_evaluations_ = 0;
  const auto& clouds = frame.scene.clouds;
  const Key key = {frame.scene.planet.seed, clouds.frequency,          clouds.persistence,       clouds.warp,
                   clouds.speed,            frame.needs.cloud_octaves, frame.needs.cloud_texels};
  if (!key_ || *key_ != key) {
    for (Picture& picture : pictures_) {
      picture.step.reset();
      if (picture.map && picture.map->side() != key.texels) picture.map.reset();
    }
    job_step_.reset();
    key_ = key;
  }

  const double interval = frame.needs.cloud_interval;
  const double time = interval > 0.0 ? frame.view.seconds / interval : 0.0;
  const auto step = static_cast<std::int64_t>(std::floor(time));
  const int pair = interval > 0.0 ? 2 : 1;
  blend_ = time - static_cast<double>(step);
  const int all_rows = 6 * key.texels;
  const auto hasty_rows = static_cast<int>(noise_a_frame / (std::int64_t{key.texels} * key.octaves));

  if (frame.effort == Effort::complete || (pair == 2 && picture_of(step) != nullptr && job_step_ == step + 1)) {
    // What is missing is made at once: all of it, or the rest of the picture that time has caught up with.
    while (advance(frame, step, pair, all_rows)) {
    }
  }
  const bool have_pair = picture_of(step) != nullptr && picture_of(step + pair - 1) != nullptr;
  if (have_pair) {
    // The next picture keeps pace with the blend between these two.
    const auto due = static_cast<int>((blend_ + 0.1) * all_rows);
    const int done = job_step_ == step + 2 ? job_.rows_done() : 0;
    if (pair == 2 && frame.effort == Effort::live && due > done) advance(frame, step, 3, due - done);
    before_ = picture_of(step)->map.get();
    after_ = picture_of(step + pair - 1)->map.get();
  } else {
    if (frame.effort == Effort::live) advance(frame, step, pair, hasty_rows);
    make_coarse(frame);
  }
  coarse_in_use_ = !have_pair;
}

const CloudsShell::Picture* CloudsShell::picture_of(std::int64_t step) const {
  const auto found = std::find_if(pictures_.begin(), pictures_.end(), [&](const Picture& p) { return p.step == step; });
  return found == pictures_.end() ? nullptr : &*found;
}

bool CloudsShell::advance(const Frame& frame, std::int64_t step, int steps, int rows) {
  std::int64_t missing = step;
  while (missing < step + steps && picture_of(missing) != nullptr) ++missing;
  if (missing == step + steps) return false;
  if (job_step_ != missing) {
    const auto free = std::find_if(pictures_.begin(), pictures_.end(), [&](const Picture& p) {
      return !p.step || *p.step < step || *p.step >= step + steps;
    });
    job_picture_ = static_cast<std::size_t>(free - pictures_.begin());
    free->step.reset();
    if (!free->map) free->map = std::make_unique<gl::CubeMap>(key_->texels, gl::Format::r16f);
    job_step_ = missing;
    job_.restart();
  }
  Picture& picture = pictures_.at(job_picture_);
  bake(frame, job_, *picture.map, static_cast<double>(missing) * frame.needs.cloud_interval, rows);
  if (job_.done(*picture.map)) {
    picture.step = missing;
    job_step_.reset();
  }
  return true;
}

void CloudsShell::make_coarse(const Frame& frame) {
  if (!coarse_) coarse_ = std::make_unique<gl::CubeMap>(coarse_cloud_texels, gl::Format::r16f);
  coarse_bake_.restart();
  bake(frame, coarse_bake_, *coarse_, frame.view.seconds, CubeBake::rows(*coarse_));
  before_ = after_ = coarse_.get();
  blend_ = 0.0;
}

void CloudsShell::bake(const Frame& frame, CubeBake& bake, const gl::CubeMap& map, double seconds, int rows) {
  const int octaves = frame.needs.cloud_octaves;
  bake_program_.use();
  bake_program_.set("octaves", octaves);
  std::array<float, 12> angles{};
  for (int i = 0; i < octaves; ++i) {
    // Layer i turns 2^i times as fast (18); reduced to one turn before it is rounded.
    const double angle = std::ldexp(frame.scene.clouds.speed * seconds, i);
    angles.at(static_cast<std::size_t>(i)) = static_cast<float>(std::remainder(angle, 2.0 * std::numbers::pi));
  }
  for (int i = 0; i < 3; ++i) {
    const float* a = angles.data() + 4 * i;
    const char* names[] = {"angles[0]", "angles[1]", "angles[2]"};
    bake_program_.set(names[i], a[0], a[1], a[2], a[3]);
  }
  noise_evaluations_ += bake.advance(bake_program_, map, rows) * octaves;
}

void CloudsShell::bind_maps() const {
  before_->bind(gl::unit_clouds_before);
  after_->bind(gl::unit_clouds_after);
}

void CloudsShell::draw(const Frame& frame) {
  const double shell = 1.0 + frame.scene.clouds.height / frame.scene.planet.radius;
  const bool above = glm::dot(frame.pose.eye, frame.pose.eye) > shell * shell;
  draw_program_.use();
  glEnable(GL_CULL_FACE);
  glCullFace(above ? GL_BACK : GL_FRONT);
  spheres_.directions(5).draw();
  glCullFace(GL_BACK);
}

}  // namespace terrella
