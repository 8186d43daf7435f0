#include "measure/node_picture.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/milliseconds.hpp"
#include "passes/node_meshes.hpp"
#include "planet/node_grids.hpp"
#include "planet/terrain.hpp"

namespace terrella {
namespace {

glm::dvec3 centre_of(const NodeFrame& frame) { return (1.0 + frame.base) * frame.outline.middle; }

}  // namespace

NodePicture::NodePicture(const Scene& scene, const View& view)
    : scene_(scene),
      view_(view),
      pose_(pose_of(scene, view)),
      needs_(needs_of(scene, view, pose_)),
      terrain_(exact_terrain_of(scene)),
      grid_(grid_of(needs_.ground, scene, pose_)),
      patch_(grid_->patch(needs_.ground_cells)),
      ranges_(ranges_of(*grid_, needs_)),
      sight_(sight_of_nodes(scene, needs_, pose_, view)),
      details_(details_of(scene, *grid_, patch_.cells)),
      cache_(node_room(vertices_of_patch(patch_.sides, patch_.cells))) {
  for (const Skirt skirt : {Skirt::without, Skirt::with}) {
    for (unsigned list = 0; list < patch_.lists(); ++list) {
      triangles_.at(static_cast<std::size_t>(skirt)).at(list) = node_triangles(patch_, list, skirt == Skirt::with);
    }
  }
  const auto start = std::chrono::steady_clock::now();
  for (const GridNode& root : grid_->roots()) make(root);
  look();
  choose();
  while (choice_.lacks && make_missing()) choose();
  making_ms_ = milliseconds_since(start);
}

void NodePicture::look() { eye_ = eye_over(terrain_, pose_); }

void NodePicture::choose() {
  cache_.begin_frame();
  choose_nodes(*grid_, sight_, eye_, ranges_, cache_, choice_);
}

bool NodePicture::make_missing() {
  return std::all_of(choice_.missing.begin(), choice_.missing.end(),
                     [&](const MissingNode& missing) { return make(missing.node); });
}

bool NodePicture::make(const GridNode& node) {
  if (!cache_.has_room()) return false;
  const NodeFrame made = make_node(*grid_, patch_, node, terrain_, scratch_);
  const auto slot = static_cast<std::size_t>(*cache_.insert(node, made));
  if (slot >= vertices_.size()) vertices_.resize(slot + 1);
  vertices_[slot] = scratch_;
  ++made_;
  return true;
}

std::vector<DrawnNode> NodePicture::hidden() const {
  std::vector<DrawnNode> all;
  for (const NodeSilhouette& silhouette : choice_.silhouettes.all) {
    const bool is_drawn = std::any_of(choice_.drawn.begin(), choice_.drawn.end(),
                                      [&](const DrawnNode& drawn) { return drawn.slot == silhouette.drawn.slot; });
    if (!is_drawn) all.push_back(silhouette.drawn);
  }
  return all;
}

bool NodePicture::shows(NodeLayer layer, const DrawnNode& drawn) const {
  const NodeCache::Entry& entry = cache_.at(drawn.slot);
  return terrella::shows(layer, entry.frame, details_.at(static_cast<std::size_t>(entry.node.level)), sight_);
}

// As in shaders/node_vertex.glsl.
std::vector<double> NodePicture::coarse_parts_of(const DrawnNode& drawn) const {
  const NodeCache::Entry& entry = cache_.at(drawn.slot);
  const glm::dvec3 centre = centre_of(entry.frame);
  std::vector<double> parts;
  for (const glm::vec4& place : vertices_[static_cast<std::size_t>(drawn.slot)].place) {
    const bool meets_coarser = (patch_.vertices[parts.size()].touches & drawn.coarser) != 0;
    const double chord = glm::distance(glm::normalize(centre + glm::dvec3(place)), eye_.direction);
    const double away = std::hypot(eye_.lift, chord) / grid_->edge(entry.node.level);
    const double part = (away - ranges_.morph_begin()) / (ranges_.morph_end() - ranges_.morph_begin());
    parts.push_back(meets_coarser ? 1.0 : std::clamp(part, 0.0, 1.0));
  }
  return parts;
}

std::vector<glm::dvec3> NodePicture::vertices_of(const DrawnNode& drawn) const { return places_of(told_by(drawn)); }

// As in shaders/node_vertex.glsl.
std::vector<ToldGround> NodePicture::told_by(const DrawnNode& drawn) const {
  const NodeCache::Entry& entry = cache_.at(drawn.slot);
  const NodeVertices& vertices = vertices_[static_cast<std::size_t>(drawn.slot)];
  const glm::dvec3 centre = centre_of(entry.frame);
  const double spacing = grid_->spacing(entry.node.level, patch_.cells);
  const auto ice_in = [](double shape) { return 0.5 * std::floor(2.0 * shape / ice_flag + 0.01); };
  std::vector<ToldGround> all;
  const std::vector<double> parts = coarse_parts_of(drawn);
  for (std::size_t n = 0; n < parts.size(); ++n) {
    const double part = parts[n];
    const glm::dvec4 place = glm::dvec4(vertices.place[n]) + part * glm::dvec4(vertices.coarser[n]);
    const glm::dvec4 slope = glm::dvec4(vertices.slope[n]) + part * glm::dvec4(vertices.coarser_slope[n]);
    const glm::dvec4 means = vertices.means[n];
    ToldGround told;
    told.from_centre = place;
    told.square = glm::dot(told.from_centre, told.from_centre);
    told.place = centre + told.from_centre;
    told.slope = slope;
    told.over = f64::over_at_vertex(place.w, told.slope, told.from_centre);
    told.iced = glm::mix(ice_in(means.y), ice_in(means.y + means.w), part);
    told.means = {means.x + part * means.z, means.y + part * means.w - ice_flag * told.iced};
    told.spacing = spacing;
    told.above = part;
    all.push_back(told);
  }
  return all;
}

const std::vector<std::uint16_t>& NodePicture::triangles_of(const DrawnNode& drawn, Skirt skirt,
                                                            NodeLayer layer) const {
  return triangles_.at(static_cast<std::size_t>(skirt)).at(list_of(patch_, drawn, layer));
}

}  // namespace terrella
