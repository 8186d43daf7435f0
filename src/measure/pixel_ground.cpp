#include "measure/pixel_ground.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

#include "planet/node_mesh.hpp"

namespace terrella {
namespace {

f64::Relief relief_told(const ToldGround& told, const f64::Terrain& terrain) {
  const auto relief_of = terrain.map.map != nullptr ? f64::mapped_relief_of : f64::relief_of;
  return relief_of(terrain, told.means.x, told.means.y);
}

double spacing_of(const ToldGround& told) { return (1.0 + told.above) * told.spacing; }

void add_layers_to(f64::FinerGround& finer, const ToldGround& told, const f64::Terrain& terrain, const glm::dvec3& up,
                   double footprint, int octaves) {
  const int first = terrain.map.map != nullptr ? f64::first_layer_beyond(f64::map_texel(terrain.map), terrain) : 0;
  double frequency = terrain.frequency, amplitude = 1.0;
  for (int i = 0; i < octaves; ++i, frequency *= terrain.lacunarity, amplitude *= terrain.persistence) {
    const double shown =
        f64::layer_weight(frequency, footprint) - f64::held_weight(frequency, told.spacing, told.above);
    if (i < first || shown <= 0.0) continue;
    f64::go_on_to(finer, frequency, spacing_of(told));
    const f64::Noise noise = f64::height_noise(up + f64::moved(finer), terrain, i, frequency);
    f64::add_finer_layer(finer, terrain, i, frequency, amplitude * shown, noise);
  }
}

void add_craters_to(f64::FinerGround& finer, const ToldGround& told, const f64::Terrain& terrain, const glm::dvec3& up,
                    double footprint) {
  if (terrain.craters.depth <= 0.0 || terrain.height <= 0.0) return;
  double frequency = terrain.craters.frequency;
  for (int i = 0; i < terrain.craters.sizes; ++i, frequency *= f64::crater_step) {
    const double shown = f64::crater_weight(frequency, footprint) -
                         f64::held_weight(f64::crater_detail * frequency, told.spacing, told.above);
    if (shown <= 0.0) continue;
    f64::go_on_to(finer, frequency, spacing_of(told));
    f64::add_finer_craters(finer, terrain, up, i, frequency, shown);
  }
}

void add_map_to(f64::FinerGround& finer, const ToldGround& told, const f64::Terrain& terrain, const glm::dvec3& up,
                double footprint) {
  if (terrain.map.map == nullptr) return;
  const glm::dvec3 direction = glm::normalize(up + f64::moved(finer));
  const f64::MapHeight shown = f64::map_height_at(terrain.map, direction, footprint);
  const f64::MapHeight held = f64::map_height_at(terrain.map, direction, f64::held_footprint(told.spacing));
  const f64::MapHeight above = f64::map_height_at(terrain.map, direction, f64::held_footprint(2.0 * told.spacing));
  f64::add_to_shape(finer, shown.value - glm::mix(held.value, above.value, told.above),
                    shown.gradient - glm::mix(held.gradient, above.gradient, told.above));
}

}  // namespace

ToldGround between(const ToldGround& a, const ToldGround& b, const ToldGround& c, const glm::dvec3& parts) {
  const auto mean = [&](auto ToldGround::*of) { return parts.x * a.*of + parts.y * b.*of + parts.z * c.*of; };
  ToldGround told;
  told.place = mean(&ToldGround::place);
  told.over = mean(&ToldGround::over);
  told.slope = mean(&ToldGround::slope);
  told.means = mean(&ToldGround::means);
  told.iced = mean(&ToldGround::iced);
  told.spacing = a.spacing;
  told.from_centre = mean(&ToldGround::from_centre);
  told.square = mean(&ToldGround::square);
  told.above = mean(&ToldGround::above);
  return told;
}

std::vector<glm::dvec3> places_of(const std::vector<ToldGround>& vertices) {
  std::vector<glm::dvec3> places;
  for (const ToldGround& vertex : vertices) places.push_back(vertex.place);
  return places;
}

glm::dvec3 shown_place(const ToldGround& told, const f64::Terrain& terrain, const glm::dvec3& eye, double sample,
                       int octaves) {
  f64::Terrain layers = terrain;
  if (terrain.map.map != nullptr) layers.ranges.part = 0.0;
  const glm::dvec3 up = glm::normalize(told.place), ray = glm::normalize(told.place - eye);
  const double across = sample * glm::distance(told.place, eye);
  const double footprint = across / std::max(-glm::dot(glm::normalize(up - told.slope), ray), 0.12);
  const double over = f64::over_between(told.over, told.slope, told.from_centre);
  const double sag = f64::sag_between(told.square, told.from_centre);
  f64::Relief rising = relief_told(told, terrain);
  rising.by_mean *= 1.0 - told.iced;
  rising.by_shape *= 1.0 - told.iced;
  const f64::FinerGround begun =
      f64::held_ground(layers, rising, f64::ray_at_mesh(ray, up, told.slope, over - sag), spacing_of(told), footprint);
  const auto found = [&](f64::FinerGround finer) {
    add_layers_to(finer, told, layers, up, footprint, octaves);
    add_craters_to(finer, told, layers, up, footprint);
    add_map_to(finer, told, layers, up, footprint);
    f64::go_on(finer, 4.0 * footprint);
    return finer;
  };
  f64::FinerGround finer = found(begun);
  const double doubtful = f64::part_in_doubt(finer, across);
  if (doubtful > 0.0) finer = f64::between_rays(finer, found(f64::once_more(begun, finer.ray.way)), doubtful);
  return told.place + finer.ray.way * ray;
}

}  // namespace terrella
