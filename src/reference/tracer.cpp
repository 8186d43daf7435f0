#include "reference/tracer.hpp"

#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "planet/materials.hpp"
#include "planet/milky_band.hpp"
#include "planet/rings.hpp"
#include "planet/spheres.hpp"
#include "planet/sun.hpp"
#include "planet/terrain.hpp"

namespace terrella::reference {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Layers of ripples; the steepness of further ones is below a tenth of the first one's.
constexpr int ripple_layers = 8;

// Ringlets as fine as they are.
constexpr double ring_footprint = 1e-6;

glm::dvec3 behind(const f64::Veil& veil, const glm::dvec3& light) { return veil.light + (1.0 - veil.opacity) * light; }

}  // namespace

Tracer::Tracer(const Scene& scene, const View& view, const Footprints& left_out)
    : scene_(scene),
      view_(view),
      left_out_(left_out),
      pose_(pose_of(scene, view)),
      light_(light_of(scene, pose_)),
      bands_(bands_of(scene)),
      look_(water_look_of(scene)),
      rings_(rings_of(scene)),
      small_lights_(scene, view, pose_, light_),
      resolution_(0.25 * pose_.pixel_angle),
      water_level_(terrella::water_level(scene) / scene.planet.radius),
      top_radius_(top_radius(scene)) {
  if (has_ground(scene)) ground_.emplace(scene, left_out.ground);
  if (has_water(scene)) sea_.emplace(scene, view.seconds, ground_ ? &*ground_ : nullptr);
  if (has_clouds(scene)) clouds_.emplace(scene, view.seconds, left_out.clouds);
  sun_pixel_ = pixel_at_sun(scene, pose_);
  free_sun_ = free_part_of_sun(scene, pose_, ground_ || sea_ ? 1.0 : 0.0);
}

Ray Tracer::ray_of(const glm::dvec2& pixel) const { return {pose_.eye, ray_through(pose_, view_, pixel)}; }

std::optional<Tracer::Surface> Tracer::surface_along(const Ray& ray) const {
  const Resolution resolution = {resolution_, resolution_ * pose_.clearance};
  std::optional<Surface> found;
  double before = infinity;
  if (sea_) {
    if (const auto t = sea_->hit(ray, before, resolution)) {
      const glm::dvec3 place = ray.at(*t);
      found = {*t, place, sea_->over(glm::normalize(place))};
      before = *t;
    }
  }
  if (ground_) {
    if (const auto t = ground_->hit(ray, before, resolution)) found = {*t, ray.at(*t), std::nullopt};
  }
  return found;
}

f64::Water Tracer::water_look_at(const Surface& surface) const {
  const WaterAt& water = *surface.water;
  if (sea_->has_waves()) {
    return f64::wavy_water(water.still, water.depth, water.sum, water.frame,
                           std::max(scene_.waves.amplitude / scene_.planet.radius, 1e-9), sea_->whole_depth(), look_);
  }
  const double frequency = scene_.water.ripple_frequency;
  f64::Ripples ripples = f64::no_ripples(frequency, turned(scene_.water.ripple_speed, view_.seconds));
  for (int i = 0; i < ripple_layers; ++i) {
    ripples = f64::add_ripples(ripples, water.still, scene_.water.ripples, left_out_.ripples,
                               f64::ripple_seed(scene_.planet.seed));
  }
  const double shown = f64::layer_weight(frequency, left_out_.ripples);
  return f64::calm_water(water.still, water.depth, ripples, f64::torn_crust(ripples, shown, look_), look_);
}

Sample Tracer::measured(const std::optional<Surface>& surface) const {
  Sample sample;
  sample.distance = sample.height = infinity;
  if (!surface) return sample;
  const double radius = glm::length(surface->place);
  sample.distance = surface->distance;
  sample.height = radius - 1.0;
  if (surface->water) {
    sample.normal = water_look_at(*surface).normal;
  } else {
    const glm::dvec3 up = surface->place / radius;
    sample.normal = f64::surface_normal(up, radius, ground_->height_at(up).gradient);
  }
  return sample;
}

double Tracer::shade_at(const glm::dvec3& place) const { return clouds_ ? clouds_->shade(place, light_.sun) : 1.0; }

f64::GroundAt Tracer::ground_at(const glm::dvec3& up) const {
  const f64::Height height = ground_->height_at(up);
  f64::GroundAt ground;
  ground.gradient = height.gradient - glm::dot(height.gradient, up) * up;
  ground.openness = height.openness;
  ground.height = height.value - water_level_;
  return ground;
}

glm::dvec3 Tracer::light_of_ground(const glm::dvec3& place) const {
  const double radius = glm::length(place);
  const glm::dvec3 up = place / radius;
  const f64::GroundAt ground = ground_at(up);
  const glm::dvec3 normal = f64::slope_normal(up, radius, ground.gradient);
  return f64::ground_light(f64::ground_albedo(up, ground, normal, bands_), normal,
                           f64::light_at(up, radius - 1.0, light_), shade_at(place), light_);
}

glm::dvec3 Tracer::light_from_below(const Ray& refracted, const f64::LightAt& at, double shade) const {
  const Resolution resolution = {resolution_, resolution_ * glm::distance(refracted.origin, pose_.eye)};
  const auto way = ground_ ? ground_->hit(refracted, infinity, resolution) : std::nullopt;
  if (!way) return f64::light_through(glm::dvec3(0.0), at.up, bottomless, bottomless, at, shade, look_, light_);
  const glm::dvec3 up = glm::normalize(refracted.at(*way));
  f64::GroundAt bottom = ground_at(up);
  const glm::dvec3 normal = f64::slope_normal(up, 1.0 + water_level_ + bottom.height, bottom.gradient);
  bottom.height = std::min(bottom.height, 0.0);
  return f64::light_through(f64::ground_albedo(up, bottom, normal, bands_), normal, -bottom.height, *way, at, shade,
                            look_, light_);
}

glm::dvec3 Tracer::light_mirrored(const Ray& mirrored, const f64::LightAt& at) const {
  const Resolution resolution = {resolution_, resolution_ * glm::distance(mirrored.origin, pose_.eye)};
  if (ground_) {
    if (const auto t = ground_->hit(mirrored, infinity, resolution)) return light_of_ground(mirrored.at(*t));
  }
  return f64::sky_along(at, mirrored.direction, light_);
}

glm::dvec3 Tracer::light_of_water(const Ray& ray, const Surface& surface) const {
  const f64::Water water = water_look_at(surface);
  const f64::LightAt at = f64::light_at(surface.water->still, 0.0, light_);
  const double shade = shade_at(surface.water->still * sea_->still_radius());
  const glm::dvec3 refracted = f64::refracted_ray(ray.direction, water.normal, look_);
  const glm::dvec3 below = light_from_below({surface.place, refracted}, at, shade);
  const glm::dvec3 mirrored = light_mirrored({surface.place, glm::reflect(ray.direction, water.normal)}, at);
  return f64::water_light(water, at, ray.direction, below, mirrored, shade, look_, light_);
}

glm::dvec3 Tracer::light_of_sky(const Ray& ray) const {
  glm::dvec3 light(0.0);
  if (has_stars(scene_) && scene_.stars.band > 0.0) {
    light += f64::band_light(milky_band_brightness(scene_, ray.direction), scene_.stars.brightness) *
             f64::sky_shown(ray.direction, light_);
  }
  if (scene_.sun.size > 0.0) {
    const double away = f64::tangent_from_sun(ray.direction, light_.sun);
    light += f64::sunlight_at_eye(light_) *
             (f64::disc_brightness * f64::disc_of_sun(away, seen_sun_radius(scene_), sun_pixel_));
  }
  return light;
}

glm::dvec3 Tracer::glare(const Ray& ray) const {
  const double strength = f64::glare_brightness * free_sun_ * scene_.sun.glare;
  const double away = f64::tangent_from_sun(ray.direction, light_.sun);
  if (strength <= 0.0 || away >= f64::glare_reach) return glm::dvec3(0.0);
  return f64::sunlight_at_eye(light_) * (strength * f64::glare_of_sun(away, seen_sun_radius(scene_), f64::glare_reach));
}

glm::dvec3 Tracer::before_veils(const Ray& ray, double distance, glm::dvec3 light) const {
  double rings_at = infinity;
  if (has_rings(scene_) && ray.direction.z != 0.0) {
    const double t = -ray.origin.z / ray.direction.z;
    const double radius = glm::length(ray.at(t));
    if (t > 0.0 && t < distance && radius > rings_.inner && radius < rings_.outer) rings_at = t;
  }
  const auto add_rings = [&] {
    light = behind(f64::ring_veil(ray.at(rings_at), ray.direction, rings_, ring_footprint, light_), light);
  };
  // Behind the planet and its air, where the ray has passed its nearest place.
  const bool rings_behind = glm::dot(ray.at(std::min(rings_at, 1e9)), ray.direction) > 0.0;
  if (rings_at < infinity && rings_behind) add_rings();
  if (distance == infinity) light = behind(f64::air_before_sky(ray.direction, light_), light);
  if (clouds_) {
    const auto t = meets_sphere(ray, cloud_radius(scene_));
    if (t && *t < distance) {
      const f64::CloudAt cloud = clouds_->at(glm::normalize(ray.at(*t)), light_.sun);
      light = behind(f64::cloud_veil(cloud, *t * ray.direction, clouds_->clouds(), light_), light);
    }
  }
  if (has_rings(scene_) && glm::length(pose_.eye) > top_radius_) {
    const auto t = meets_sphere(ray, top_radius_);
    if (t && *t < distance) light *= 1.0 - f64::ring_shadow(ray.at(*t), rings_, light_);
  }
  if (rings_at < infinity && !rings_behind) add_rings();
  return light;
}

Sample Tracer::geometry(const glm::dvec2& pixel) const { return measured(surface_along(ray_of(pixel))); }

Sample Tracer::sample(const glm::dvec2& pixel) const {
  const Ray ray = ray_of(pixel);
  const std::optional<Surface> surface = surface_along(ray);
  Sample sample = measured(surface);
  glm::dvec3 light;
  if (surface) {
    const glm::dvec3 up = surface->water ? surface->water->still : glm::normalize(surface->place);
    const double height = surface->water ? 0.0 : sample.height;
    light = surface->water ? light_of_water(ray, *surface) : light_of_ground(surface->place);
    light = f64::through_air(light, f64::light_at(up, height, light_), surface->distance * ray.direction, light_);
  } else {
    light = light_of_sky(ray);
  }
  const double depth = surface ? surface->distance * glm::dot(ray.direction, pose_.forward) : infinity;
  light += small_lights_.at(pixel, depth);
  sample.light = before_veils(ray, sample.distance, light) + glare(ray);
  return sample;
}

}  // namespace terrella::reference
