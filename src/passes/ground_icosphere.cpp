#include "passes/ground_icosphere.hpp"

#include <algorithm>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

#include "passes/layers.hpp"

namespace terrella {
namespace {

// Noise evaluated in one frame towards the fine map and mesh, so that the picture goes on moving meanwhile.
constexpr std::int64_t map_noise_a_frame = 1'600'000;
constexpr std::int64_t mesh_noise_a_frame = 120'000;

bool lower(const RadiusRange& a, const RadiusRange& b) { return a.lowest < b.lowest; }

}  // namespace

GroundIcosphere::GroundIcosphere(SphereMeshes& spheres) : spheres_(spheres) {}

void GroundIcosphere::begin(const Scene& scene, const Needs& needs) {
  const f64::Terrain relief = exact_terrain_of(scene);
  if (relief_ == relief || begun_relief_ == relief) return;
  begun_relief_ = relief;
  std::vector<glm::vec3> positions;
  displace(scene, coarse_level, spheres_.geometry(coarse_level).directions.size(), positions);
  begun_.emplace(make_surface(needs.ground_tolerance, coarse_level, std::move(positions)));
}

void GroundIcosphere::want(const Needs& needs) {
  bake_program_.want(needs.ground_mapped ? "ground/bake_mapped" : "ground/bake");
  draw_program_.want(std::string(refines_ground(needs) ? "ground/icosphere_near" : "ground/icosphere") +
                     (needs.in_water ? "_in_water" : ""));
}

void GroundIcosphere::update(const Frame& frame) {
  noise_evaluations_ = 0;
  const f64::Terrain relief = exact_terrain_of(frame.scene);
  const bool changed = relief_ != relief;
  if (changed) {
    if (frame.effort != Effort::complete) begin(frame.scene, frame.needs);
    relief_ = relief;
    fine_.reset();
    former_.reset();
    making_.reset();
  }
  wanted_ = {frame.needs.ground_level, frame.needs.ground_texels};
  if (!settled() && former_ && former_->fineness == wanted_) std::swap(fine_, former_);
  if (frame.effort == Effort::complete) {
    while (!settled()) advance_fine(frame);
  } else if (changed) {
    make_coarse(frame);
  } else if (!settled() && frame.effort == Effort::live) {
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
  begun_relief_.reset();
  coarse_ = std::exchange(begun_, {});
  noise_evaluations_ += static_cast<std::int64_t>(coarse_->positions.size()) *
                        noise_per_height(frame.scene, icosphere_edge(coarse_level));
}

void GroundIcosphere::begin_fine() {
  making_.emplace();
  making_->fineness = wanted_;
  making_->map = std::make_unique<gl::CubeMap>(wanted_.texels, gl::Format::rgba16f);
}

void GroundIcosphere::advance_fine(const Frame& frame) {
  if (!making_ || making_->fineness != wanted_) begin_fine();
  const bool at_once = frame.effort == Effort::complete;
  Making& making = *making_;
  if (!making.bake.done(*making.map)) {
    const int noise_each = noise_per_height(frame.scene, texel_angle(wanted_.texels));
    const auto rows = static_cast<int>(map_noise_a_frame / (std::int64_t{wanted_.texels} * noise_each));
    bake(frame, making.bake, *making.map, at_once ? CubeBake::rows(wanted_.texels) : rows);
  }
  const std::size_t all = spheres_.geometry(wanted_.level).directions.size();
  if (making.positions.size() < all) {
    const int noise_each = noise_per_height(frame.scene, icosphere_edge(wanted_.level));
    const auto share = static_cast<std::size_t>(mesh_noise_a_frame / noise_each);
    const std::size_t before = making.positions.size(), end = at_once ? all : before + share;
    displace(frame.scene, wanted_.level, std::min(end, all), making.positions);
    noise_evaluations_ += static_cast<std::int64_t>(making.positions.size() - before) * noise_each;
  }
  if (making.bake.done(*making.map) && making.positions.size() == all) finish_fine(frame);
}

void GroundIcosphere::finish_fine(const Frame& frame) {
  // A larger map than is asked for is not worth its memory.
  former_.reset();
  if (fine_ && fine_->fineness.texels <= wanted_.texels) former_ = std::move(fine_);
  fine_ = Fine{wanted_, make_surface(frame.needs.ground_tolerance, wanted_.level, std::move(making_->positions)),
               std::move(making_->map)};
  making_.reset();
}

void GroundIcosphere::bind_heights(const HeightMap* map) {
  gl::HeightTexture::keep(heights_, map);
  if (heights_) heights_->bind(gl::unit_heights);
}

void GroundIcosphere::bake(const Frame& frame, CubeBake& bake, gl::CubeMap& map, int rows) {
  bind_heights(frame.scene.terrain.map.map.get());
  gl::Program& program = bake_program_.use(true);
  program.set("texel_angle", static_cast<float>(texel_angle(map.side())));
  noise_evaluations_ += bake.advance(program, map, rows) * noise_per_height(frame.scene, texel_angle(map.side()));
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

void GroundIcosphere::bind_map(double level) { drawn_map().bind(gl::unit_ground, level); }

double GroundIcosphere::map_texel_angle() const { return texel_angle(drawn_map().side()); }

void GroundIcosphere::draw(const Frame& frame) {
  if (refines_ground(frame.needs)) {
    const LayerBlock block = layer_block(frame.scene, frame.pose, frame.needs.pixel_octaves_first);
    layers_.set(gl::block_layers, std::as_bytes(std::span(&block, 1)));
  }
  draw_program_.use(frame.effort == Effort::complete);
  Surface& surface = fine_ ? fine_->surface : *coarse_;
  if (surface.tolerance != frame.needs.ground_tolerance) {
    surface.tolerance = frame.needs.ground_tolerance;
    surface.mesh.set(simplified(spheres_.geometry(surface.level), surface.positions, surface.tolerance));
  }
  const RadiusRange water = water_range(frame);
  const double lowest = std::min_element(surface.ranges.begin(), surface.ranges.end(), lower)->lowest;
  // Seen from above, water hides what lies under it, troughs included: where they are deep, the ground is deeper
  // (whole_wave_depth).
  const bool from_above = glm::length(frame.pose.eye) > water.highest && !frame.needs.in_water;
  const double shown = from_above ? lowest_still_water(frame) : 0.0;
  std::vector<float> tops;
  tops.reserve(group_count);
  for (const RadiusRange& range : surface.ranges) {
    tops.push_back(range.highest < shown ? 0.0F : static_cast<float>(range.highest));
  }
  Sight sight = sight_of(frame);
  if (frame.is_mirror) sight.half_angle = std::numbers::pi;  // it is another eye's picture
  surface.mesh.draw(frame, visible_groups(sight, from_above ? std::max(lowest, water.lowest) : lowest, tops), shown);
}

}  // namespace terrella
