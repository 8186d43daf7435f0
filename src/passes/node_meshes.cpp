#include "passes/node_meshes.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "base/milliseconds.hpp"
#include "planet/octaves.hpp"
#include "planet/spheres.hpp"
#include "planet/terrain.hpp"

namespace terrella {
namespace {

// Of a pixel: skirts are no wider than what floats and the corners of pixels may leave open.
constexpr double skirt_pixels = 0.7;

// Of waves, which a straight edge between the vertices of a coarser neighbour misses by up to so much.
constexpr double wave_skirt_pixels = 3.0;

// ms for new nodes; not so few while a parameter is dragged, which makes all of them anew.
double time_for(const Frame& frame) {
  switch (frame.effort) {
    case Effort::complete: return std::numeric_limits<double>::infinity();
    case Effort::live: return frame.making_ms;
    default: return std::max(frame.making_ms, 2.0 * least_making_ms);
  }
}

glm::vec4 vector(const glm::dvec3& v, double w) { return glm::vec4(glm::dvec4(v, w)); }

}  // namespace

void NodeMeshes::start_anew(const Frame& frame) {
  terrain_ = exact_terrain_of(frame.scene);
  cache_.clear();
  details_.reset();
  gl::HeightTexture::keep(heights_, terrain_->map.map);
}

void NodeMeshes::make_room(const NodeGrid& grid, int cells) {
  if (patch_.cells == cells) return;
  patch_ = grid.patch(cells);
  details_.reset();
  const auto count = patch_.vertices.size();
  const int vertices_of_each = static_cast<int>(count), room = node_room(vertices_of_each);
  const int beside = (room + most_node_rows - 1) / most_node_rows;
  rows_ = (room + beside - 1) / beside;
  cache_ = NodeCache(room);
  for (std::size_t i = 0; i < textures_.size(); ++i)
    textures_.at(i) = std::make_unique<gl::Image>(beside * vertices_of_each, rows_, node_formats.at(i));
  std::vector<glm::ivec2> vertices;
  for (std::size_t n = 0; n < count; ++n) vertices.emplace_back(n, patch_.vertices[n].touches);
  for (const std::uint16_t n : patch_.rim) vertices.emplace_back(n, -static_cast<int>(patch_.vertices[n].touches));
  std::vector<std::uint16_t> indices;
  for (unsigned n = 0; n < patch_.lists(); ++n) {
    const std::vector<std::uint16_t> list = node_triangles(patch_, n, true);
    lists_.at(n) = {indices.size(), list.size()};
    indices.insert(indices.end(), list.begin(), list.end());
  }
  meshes_ = std::make_unique<gl::Instances>(vec4s_a_node, vertices, indices);
}

void NodeMeshes::update(const Frame& frame, std::shared_ptr<const NodeGrid> grid, Making making) {
  noise_evaluations_ = 0;
  is_full_ = false;  // another eye may leave room
  make_room(*grid, frame.needs.ground_cells);
  const bool other_nodes = grid_ != grid;
  grid_ = std::move(grid);
  if (other_nodes || terrain_ != exact_terrain_of(frame.scene)) start_anew(frame);
  ranges_ = ranges_of(*grid_, frame.needs);
  sea_ranges_ = sea_ranges_of(*grid_, frame.needs);
  for (const GridNode& root : grid_->roots()) {
    if (cache_.find(root) < 0) make(frame.scene, root);
  }
  eye_ = eye_over(*terrain_, frame.levels_for != nullptr ? *frame.levels_for : frame.pose);
  sight_ = sight_of_nodes(frame.scene, frame.needs, frame.pose, frame.view);
  choose();
  const auto start = std::chrono::steady_clock::now();
  const double time = making == Making::in_time ? time_for(frame) : 0.0;
  // What is only ahead serves pictures that follow.
  const bool looks_ahead = frame.effort != Effort::complete;
  const auto wants_more = [&] { return !is_full_ && (choice_.lacks || (looks_ahead && !choice_.missing.empty())); };
  // A whole level of detail may be missing at each turn.
  for (int turn = 0; turn <= 2 * deepest_level && wants_more() && milliseconds_since(start) < time; ++turn) {
    make_missing(frame, time - milliseconds_since(start));
    choose();
  }
  pack(frame);
}

void NodeMeshes::choose() {
  // The sea's nodes are the ground's, or what those are quarters of.
  if (sea_is_coarser()) {
    cache_.begin_frame();
    choose_nodes(*grid_, sight_, eye_, sea_ranges_, cache_, sea_choice_);
  }
  cache_.begin_frame();
  choose_nodes(*grid_, sight_, eye_, ranges_, cache_, choice_);
}

void NodeMeshes::make_missing(const Frame& frame, double time) {
  const auto start = std::chrono::steady_clock::now();
  for (const MissingNode& missing : choice_.missing) {
    if (milliseconds_since(start) >= time || !make(frame.scene, missing.node)) return;
  }
}

bool NodeMeshes::make(const Scene& scene, const GridNode& node) {
  is_full_ = !cache_.has_room();
  if (is_full_) return false;
  const NodeFrame made = make_node(*grid_, patch_, node, *terrain_, vertices_);
  const int slot = *cache_.insert(node, made);
  const int row = slot % rows_, column = slot / rows_ * static_cast<int>(patch_.vertices.size());
  textures_[0]->set_row(row, vertices_.place, column);
  textures_[1]->set_row(row, vertices_.coarser, column);
  textures_[2]->set_row(row, vertices_.slope, column);
  textures_[3]->set_row(row, vertices_.coarser_slope, column);
  textures_[4]->set_row(row, vertices_.shape_slope, column);
  textures_[5]->set_row(row, vertices_.coarser_shape_slope, column);
  textures_[6]->set_row(row, vertices_.means, column);
  noise_evaluations_ +=
      std::ssize(patch_.vertices) * std::int64_t{noise_per_height(scene, grid_->spacing(node.level, patch_.cells))};
  return true;
}

void NodeMeshes::pack(const Frame& frame) {
  const auto& terrain = frame.scene.terrain;
  const double sea_level = water_level(frame.scene) / frame.scene.planet.radius;
  instances_.clear();
  mirrored_climb_ = 0.0;
  const int beyond_map = first_layer(frame.scene);
  if (!details_) details_ = details_of(frame.scene, *grid_, patch_.cells);
  const auto add = [&](const DrawnNode& drawn) {
    const NodeCache::Entry& entry = cache_.at(drawn.slot);
    const glm::dvec3& middle = entry.frame.outline.middle;
    const double base = entry.frame.base;
    const double spacing = grid_->spacing(entry.node.level, patch_.cells);
    // Also by the level above.
    const int by_vertices =
        octaves_below(0.25, terrain.frequency, terrain.lacunarity, terrain.octaves, f64::held_footprint(2.0 * spacing));
    const int held = std::max(by_vertices, beyond_map);
    instances_.push_back(vector((1.0 + base) * middle - frame.pose.eye, drawn.slot));
    instances_.push_back(vector(middle, base));
    instances_.push_back(vector(middle - eye_.direction, grid_->edge(entry.node.level)));
    instances_.push_back(vector((1.0 + sea_level) * middle - frame.pose.eye, base - sea_level));
    instances_.emplace_back(drawn.coarser, held, std::pow(terrain.persistence, held), spacing);
  };
  const auto detail_of = [&](const NodeCache::Entry& entry) {
    return details_->at(static_cast<std::size_t>(entry.node.level));
  };
  for (const NodeLayer layer : {NodeLayer::ground, NodeLayer::sea, NodeLayer::deep_sea, NodeLayer::mirrored}) {
    auto& runs = runs_.at(static_cast<std::size_t>(layer));
    runs.clear();
    order_.clear();
    for (const DrawnNode& drawn : drawn_as(layer)) {
      const NodeCache::Entry& entry = cache_.at(drawn.slot);
      if (!shows(layer, entry.frame, detail_of(entry), sight_)) continue;
      order_.push_back({list_of(patch_, drawn, layer), entry.node.level, drawn});
      if (layer == NodeLayer::mirrored)
        mirrored_climb_ = std::max(mirrored_climb_, terrella::mirrored_climb(entry.frame, detail_of(entry), sight_));
    }
    const bool by_level = layer == NodeLayer::deep_sea && frame.needs.water == Water::waves;
    // Nearest first, as they were, but for that.
    std::stable_sort(order_.begin(), order_.end(), [&](const InOrder& a, const InOrder& b) {
      return a.list < b.list || (a.list == b.list && by_level && a.level < b.level);
    });
    for (const InOrder& next : order_) {
      if (runs.empty() || runs.back().list != next.list || (by_level && runs.back().coarsest != next.level))
        runs.push_back({next.list, instances_.size() / vec4s_a_node, 0, next.level});
      add(next.drawn);
      ++runs.back().count;
      runs.back().coarsest = std::min(runs.back().coarsest, next.level);
    }
  }
  meshes_->set(instances_);
}

void NodeMeshes::draw(const Frame& frame, const gl::Program& program, NodeLayer layer, const OfLevel& of_level) const {
  for (std::size_t i = 0; i < textures_.size(); ++i) textures_.at(i)->bind(gl::unit_nodes + static_cast<int>(i));
  if (heights_) heights_->bind(gl::unit_heights);
  program.set("node_vertices", static_cast<int>(patch_.vertices.size()));
  const NodeRanges& ranges = is_sea(layer) ? sea_ranges_ : ranges_;
  const bool waves = is_sea(layer) && frame.needs.water == Water::waves;
  const double skirt = (waves ? wave_skirt_pixels : skirt_pixels) * frame.pose.pixel_angle;
  program.set("node_morph", static_cast<float>(ranges.morph_begin()), static_cast<float>(ranges.morph_end()),
              static_cast<float>(eye_.lift * eye_.lift), static_cast<float>(skirt));
  for (const Run& run : runs_.at(static_cast<std::size_t>(layer))) {
    if (of_level) of_level(grid_->spacing(run.coarsest, patch_.cells));
    meshes_->draw(lists_.at(run.list).first, lists_.at(run.list).count, run.first, run.count);
  }
}

}  // namespace terrella
