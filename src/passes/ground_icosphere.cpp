#include "passes/ground_icosphere.hpp"

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include "passes/layers.hpp"
#include "planet/terrain.hpp"

namespace terrella {
namespace {

// Noise evaluated in one frame towards the fine map and mesh, so that the picture goes on moving meanwhile.
constexpr std::int64_t map_noise_a_frame = 1'600'000;
constexpr std::int64_t mesh_noise_a_frame = 120'000;

bool lower(const RadiusRange& a, const RadiusRange& b) { return a.lowest < b.lowest; }

}  // namespace

GroundIcosphere::GroundIcosphere(SphereMeshes& spheres) : spheres_(spheres) {}

GroundIcosphere::Key GroundIcosphere::key_of(const Scene& scene, const Needs& needs) {
  return {scene.planet,       scene.terrain,      water_level(scene), scene.water.ice_latitude,
          needs.ground_level, needs.ground_texels};
}

void GroundIcosphere::begin(const Scene& scene, const Needs& needs) {
  const Key key = key_of(scene, needs);
  if (key_ == key || begun_key_ == key) return;
  begun_key_ = key;
  std::vector<glm::vec3> positions;
  displace(scene, coarse_level, spheres_.geometry(coarse_level).directions.size(), positions);
  begun_.emplace(make_surface(needs.ground_tolerance, coarse_level, std::move(positions)));
}

void GroundIcosphere::want(const Needs& needs) {
  draw_program_.want(refines_ground(needs) ? "ground/icosphere_near" : "ground/icosphere");
}

void GroundIcosphere::update(const Frame& frame) {
  noise_evaluations_ = 0;
  const Key key = key_of(frame.scene, frame.needs);
  const bool changed = !key_ || *key_ != key;
  if (changed) {
    if (frame.effort != Effort::complete) begin(frame.scene, frame.needs);
    key_ = key;
    coarse_done_ = fine_done_ = false;
    fine_positions_.clear();
    fine_bake_.restart();
  }
  if (frame.effort == Effort::complete) {
    while (!fine_done_) advance_fine(frame);
  } else if (changed) {
    make_coarse(frame);
  } else if (!fine_done_ && frame.effort == Effort::live) {
    advance_fine(frame);
  }
}

GroundIcosphere::Surface GroundIcosphere::make_surface(double tolerance, int level, std::vector<glm::vec3> positions) {
  const Icosphere& sphere = spheres_.geometry(level);
  GroupedMesh mesh(positions, simplified(sphere, positions, tolerance));
  std::vector<RadiusRange> ranges = radius_ranges(sphere, positions);
  return {level, std::move(positions), std::move(ranges), std::move(mesh), tolerance};
}

void GroundIcosphere::make_coarse(const Frame& frame) {
  if (!coarse_map_) coarse_map_ = std::make_unique<gl::CubeMap>(coarse_ground_texels, gl::Format::rgba16f);
  coarse_bake_.restart();
  bake(frame, coarse_bake_, *coarse_map_, CubeBake::rows(coarse_ground_texels));
  begun_key_.reset();
  coarse_ = std::exchange(begun_, {});
  noise_evaluations_ += static_cast<std::int64_t>(coarse_->positions.size()) *
                        noise_per_height(frame.scene, icosphere_edge(coarse_level));
  coarse_done_ = true;
}

void GroundIcosphere::advance_fine(const Frame& frame) {
  const bool at_once = frame.effort == Effort::complete;
  const Icosphere& sphere = spheres_.geometry(key_->level);
  if (!fine_map_ || fine_map_->side() != key_->texels) {
    fine_map_ = std::make_unique<gl::CubeMap>(key_->texels, gl::Format::rgba16f);
  }
  if (!fine_bake_.done(*fine_map_)) {
    const int noise_each = noise_per_height(frame.scene, texel_angle(key_->texels));
    const auto rows = static_cast<int>(map_noise_a_frame / (std::int64_t{key_->texels} * noise_each));
    bake(frame, fine_bake_, *fine_map_, at_once ? CubeBake::rows(key_->texels) : rows);
  }
  if (fine_positions_.size() < sphere.directions.size()) {
    const int noise_each = noise_per_height(frame.scene, icosphere_edge(key_->level));
    const auto share = static_cast<std::size_t>(mesh_noise_a_frame / noise_each);
    const std::size_t end = at_once ? sphere.directions.size() : fine_positions_.size() + share;
    const std::size_t before = fine_positions_.size();
    displace(frame.scene, key_->level, std::min(end, sphere.directions.size()), fine_positions_);
    noise_evaluations_ += static_cast<std::int64_t>(fine_positions_.size() - before) * noise_each;
  }
  const bool all_there = fine_positions_.size() == sphere.directions.size();
  if (fine_bake_.done(*fine_map_) && all_there) {
    fine_.emplace(make_surface(frame.needs.ground_tolerance, key_->level, std::exchange(fine_positions_, {})));
    fine_done_ = true;
  }
}

void GroundIcosphere::bake(const Frame& frame, CubeBake& bake, gl::CubeMap& map, int rows) {
  bake_program_.use();
  bake_program_.set("texel_angle", static_cast<float>(texel_angle(map.side())));
  noise_evaluations_ += bake.advance(bake_program_, map, rows) * noise_per_height(frame.scene, texel_angle(map.side()));
}

void GroundIcosphere::displace(const Scene& scene, int level, std::size_t end, std::vector<glm::vec3>& positions) {
  const std::vector<glm::dvec3>& directions = spheres_.geometry(level).directions;
  const f32::Terrain terrain = terrain_of(scene);
  const double edge = icosphere_edge(level);
  while (positions.size() < end) {
    const glm::dvec3& direction = directions[positions.size()];
    positions.emplace_back(direction * ground_radius(terrain, direction, edge));
  }
}

void GroundIcosphere::bind_map(double level) { (fine_done_ ? fine_map_ : coarse_map_)->bind(gl::unit_ground, level); }

double GroundIcosphere::map_texel_angle() const { return texel_angle((fine_done_ ? fine_map_ : coarse_map_)->side()); }

void GroundIcosphere::draw(const Frame& frame) {
  if (refines_ground(frame.needs)) {
    const LayerBlock block = layer_block(frame.scene, frame.pose, frame.needs.pixel_octaves_first);
    layers_.set(gl::block_layers, std::as_bytes(std::span(&block, 1)));
  }
  draw_program_.use(frame.effort == Effort::complete);
  Surface& surface = fine_done_ ? *fine_ : *coarse_;
  if (surface.tolerance != frame.needs.ground_tolerance) {
    surface.tolerance = frame.needs.ground_tolerance;
    surface.mesh.set(simplified(spheres_.geometry(surface.level), surface.positions, surface.tolerance));
  }
  const RadiusRange water = water_range(frame);
  const double lowest = std::min_element(surface.ranges.begin(), surface.ranges.end(), lower)->lowest;
  // Seen from above, water hides what lies under it, troughs included: where they are deep, the ground is deeper
  // (whole_wave_depth).
  const double shown = glm::length(frame.pose.eye) > water.highest ? lowest_still_water(frame) : 0.0;
  std::vector<float> tops;
  tops.reserve(group_count);
  for (const RadiusRange& range : surface.ranges) {
    tops.push_back(range.highest < shown ? 0.0F : static_cast<float>(range.highest));
  }
  surface.mesh.draw(frame, visible_groups(sight_of(frame), std::max(lowest, water.lowest), tops), shown);
}

}  // namespace terrella
