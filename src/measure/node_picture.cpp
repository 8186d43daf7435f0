#include "measure/node_picture.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/milliseconds.hpp"
#include "passes/node_meshes.hpp"
#include "planet/terrain.hpp"

namespace terrella {
namespace {

glm::dvec3 centre_of(const NodeFrame& frame) { return (1.0 + frame.base) * frame.middle; }

}  // namespace

NodePicture::NodePicture(const Scene& scene, const View& view)
    : scene_(scene),
      view_(view),
      pose_(pose_of(scene, view)),
      needs_(needs_of(scene, view, pose_)),
      terrain_(exact_terrain_of(scene)),
      ranges_(ranges_of(needs_)),
      sight_(sight_of_nodes(scene, needs_, pose_, view)),
      cache_(node_slots),
      places_(node_slots) {
  for (const Skirt skirt : {Skirt::without, Skirt::with}) {
    for (unsigned coarser = 0; coarser < 16; ++coarser) {
      triangles_.at(static_cast<std::size_t>(skirt)).at(coarser) =
          node_triangles(ranges_.cells, coarser, skirt == Skirt::with);
    }
  }
  const auto start = std::chrono::steady_clock::now();
  for (const QuadNode& root : root_nodes()) make(root);
  look();
  choose();
  while (!choice_.missing.empty() && make_missing()) choose();
  making_ms_ = milliseconds_since(start);
}

void NodePicture::look() { eye_ = eye_over(terrain_, pose_); }

void NodePicture::choose() {
  cache_.begin_frame();
  choose_nodes(sight_, eye_, ranges_, cache_, choice_);
}

bool NodePicture::make_missing() {
  return std::all_of(choice_.missing.begin(), choice_.missing.end(),
                     [&](const MissingNode& missing) { return make(missing.node); });
}

bool NodePicture::make(const QuadNode& node) {
  if (!cache_.has_room()) return false;
  const NodeFrame made = make_node(node, ranges_.cells, terrain_, scratch_);
  places_[static_cast<std::size_t>(*cache_.insert(node, made))] = {scratch_.place, scratch_.coarser};
  ++made_;
  return true;
}

bool NodePicture::shows(NodeLayer layer, const DrawnNode& drawn) const {
  return terrella::shows(layer, cache_.at(drawn.slot), scene_, needs_, pose_);
}

// As in shaders/node_vertex.glsl.
bool NodePicture::meets_coarser(int i, int j, unsigned coarser) const {
  const bool left = i == 0, right = i == ranges_.cells, bottom = j == 0, top = j == ranges_.cells;
  const std::array<bool, 8> touches = {left,           right,           bottom,      top,
                                       left && bottom, right && bottom, left && top, right && top};
  for (unsigned bit = 0; bit < touches.size(); ++bit) {
    if (touches.at(bit) && (coarser >> bit & 1U) != 0) return true;
  }
  return false;
}

std::vector<double> NodePicture::coarse_parts_of(const DrawnNode& drawn) const {
  const NodeCache::Entry& entry = cache_.at(drawn.slot);
  const glm::dvec3 centre = centre_of(entry.frame);
  const int row = ranges_.cells + 1;
  std::vector<double> parts;
  for (const glm::vec4& place : places_[static_cast<std::size_t>(drawn.slot)].own) {
    const auto n = static_cast<int>(parts.size());
    const double chord = glm::distance(glm::normalize(centre + glm::dvec3(place)), eye_.direction);
    const double away = std::hypot(eye_.lift, chord) / node_edge(entry.node.level);
    const double part = (away - ranges_.morph_begin()) / (ranges_.morph_end() - ranges_.morph_begin());
    parts.push_back(meets_coarser(n % row, n / row, drawn.coarser) ? 1.0 : std::clamp(part, 0.0, 1.0));
  }
  return parts;
}

std::vector<glm::dvec3> NodePicture::vertices_of(const DrawnNode& drawn) const {
  const Places& places = places_[static_cast<std::size_t>(drawn.slot)];
  const glm::dvec3 centre = centre_of(cache_.at(drawn.slot).frame);
  std::vector<glm::dvec3> vertices;
  const std::vector<double> parts = coarse_parts_of(drawn);
  for (std::size_t n = 0; n < parts.size(); ++n)
    vertices.push_back(centre + glm::dvec3(places.own[n]) + parts[n] * glm::dvec3(places.coarser[n]));
  return vertices;
}

const std::vector<std::uint16_t>& NodePicture::triangles_of(const DrawnNode& drawn, Skirt skirt) const {
  return triangles_.at(static_cast<std::size_t>(skirt)).at(drawn.coarser & 15U);
}

}  // namespace terrella
