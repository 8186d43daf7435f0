#include "passes/milky_glow.hpp"

#include <glm/geometric.hpp>

#include "passes/sky_view.hpp"

namespace terrella {

static_assert(band_square < SkyView::margin);

void MilkyGlow::set(const Scene& scene) {
  glow_ = find_band_glow(scene);
  parts_.forget();
  mesh_.reset();
  directions_.clear();
  for (const glm::vec3& vertex : glow_.vertices) directions_.push_back(glm::normalize(vertex));
  if (!glow_.vertices.empty()) mesh_.emplace(glow_.vertices);
}

Chosen MilkyGlow::choose(const Frame& frame) const {
  const SkyView view(frame);
  Chosen shown;
  for (std::uint32_t i = 0; i < glow_.indices.size(); i += 6) {
    const glm::vec3 &from = directions_[glow_.indices[i]], &to = directions_[glow_.indices[i + 5]];
    if (view.within_picture(from) && !(view.behind_planet(from) && view.behind_planet(to))) shown.push_back(i);
  }
  return shown;
}

void MilkyGlow::draw(const Frame& frame) {
  if (!mesh_) return;
  const auto append = [&](const Chosen& squares, std::vector<std::uint32_t>& indices) {
    for (const std::uint32_t i : squares) {
      const auto first = glow_.indices.begin() + static_cast<std::ptrdiff_t>(i);
      indices.insert(indices.end(), first, first + 6);
    }
  };
  const auto send = [&](const std::vector<std::uint32_t>& indices) { mesh_->set_indices(indices); };
  const auto [first, count] = parts_.range_of(choose(frame), draws_all(frame), append, send);
  program_->use();
  mesh_->draw(first, count);
}

}  // namespace terrella
