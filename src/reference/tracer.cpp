#include "reference/tracer.hpp"

#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "planet/materials.hpp"
#include "planet/milky_band.hpp"
#include "planet/needs.hpp"
#include "planet/rings.hpp"
#include "planet/shores.hpp"
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
      lens_(lens_above_water(pose_)),
      in_water_(is_in_water(pose_, view)),
      wet_height_(wet_height(scene, make_sea(scene, view.seconds))),
      rings_(rings_of(scene)),
      small_lights_(scene, view, pose_, light_),
      piece_(0.25 * pose_.pixel_angle),
      water_level_(terrella::water_level(scene) / scene.planet.radius),
      top_radius_(top_radius(scene)) {
  if (has_ground(scene)) ground_.emplace(scene, left_out.ground);
  if (has_water(scene)) sea_.emplace(scene, view.seconds, ground_ ? &*ground_ : nullptr);
  if (has_clouds(scene)) clouds_.emplace(scene, view.seconds, left_out.clouds);
  sun_pixel_ = pixel_at_sun(scene, pose_);
  free_sun_ = free_part_of_sun(scene, pose_, ground_ || sea_ ? 1.0 : 0.0);
}

Ray Tracer::ray_of(const glm::dvec2& pixel) const {
  const glm::dvec3 ray = ray_through(pose_, view_, pixel);
  if (!in_water_) return {pose_.eye, ray};
  return {pose_.eye + pose_.near / glm::dot(ray, pose_.forward) * ray, ray};
}

bool Tracer::begins_in_water(const Ray& ray) const { return sea_ && glm::dot(lens_, ray.direction) < 0.0; }

Resolution Tracer::resolution_from(const glm::dvec3& place) const {
  return {piece_, piece_ * glm::distance(place, pose_.eye)};
}

std::optional<Tracer::Surface> Tracer::surface_along(const Ray& ray) const {
  const Resolution resolution = {piece_, piece_ * pose_.nearest};
  const bool from_below = begins_in_water(ray);
  const auto water = !sea_        ? std::nullopt
                     : from_below ? sea_->hit_from_below(ray, infinity, resolution)
                                  : sea_->hit(ray, infinity, resolution);
  const auto ground = ground_ ? ground_->hit(ray, water.value_or(infinity), resolution) : std::nullopt;
  if (ground) return Surface{*ground, ground_at(ray.at(*ground))};
  if (water) return Surface{*water, water_at(ray.at(*water), from_below)};
  return std::nullopt;
}

Tracer::SeenGround Tracer::ground_at(const glm::dvec3& place) const {
  SeenGround ground;
  ground.radius = glm::length(place);
  ground.up = place / ground.radius;
  const f64::Height height = ground_->height_at(ground.up);
  ground.at.gradient = height.gradient - glm::dot(height.gradient, ground.up) * ground.up;
  ground.at.openness = height.openness;
  ground.at.height = height.value - water_level_;
  ground.normal = f64::slope_normal(ground.up, ground.radius, ground.at.gradient);
  return ground;
}

Tracer::SeenWater Tracer::water_at(const glm::dvec3& place, bool from_below) const {
  const WaterAt at = sea_->over(glm::normalize(place));
  if (sea_->has_waves()) {
    if (has_nodes(ground_technique(scene_)))
      return {at, f64::open_water(at.still, glm::normalize(pose_.eye - place), from_below, at.depth, at.sum, at.frame,
                                  {0.0, 0.0}, sea_->breaking(), sea_->lace_at(at.still), sea_->whole_depth(), look_)};
    const double amplitude = std::max(sea_->amplitude(), 1e-9);
    return {at, f64::wavy_water(at.still, at.depth, at.sum, at.frame, amplitude, sea_->whole_depth(), look_)};
  }
  const double frequency = scene_.water.ripple_frequency;
  f64::Ripples ripples = f64::no_ripples(frequency, turned(scene_.water.ripple_speed, view_.seconds));
  for (int i = 0; i < ripple_layers; ++i) {
    ripples = f64::add_ripples(ripples, at.still, scene_.water.ripples, left_out_.ripples,
                               f64::ripple_seed(scene_.planet.seed));
  }
  const double shown = f64::layer_weight(frequency, left_out_.ripples);
  return {at, f64::calm_water(at.still, at.depth, ripples, f64::torn_crust(ripples, shown, look_), look_)};
}

Sample Tracer::measured(const Ray& ray, const std::optional<Surface>& surface) const {
  Sample sample;
  sample.distance = sample.height = infinity;
  if (!surface) return sample;
  sample.distance = glm::distance(ray.at(surface->distance), pose_.eye);
  sample.height = glm::length(ray.at(surface->distance)) - 1.0;
  const SeenGround* ground = std::get_if<SeenGround>(&surface->what);
  sample.normal = ground != nullptr ? ground->normal : std::get<SeenWater>(surface->what).look.normal;
  return sample;
}

double Tracer::shade_at(const glm::dvec3& place) const { return clouds_ ? clouds_->shade(place, light_.sun) : 1.0; }

f64::LightAt Tracer::light_over(const SeenGround& ground) const {
  return f64::light_at(ground.up, ground.radius - 1.0, light_);
}

glm::dvec3 Tracer::albedo_of(const SeenGround& ground) const {
  const glm::dvec3 dry = f64::ground_albedo(ground.up, ground.at, ground.normal, bands_);
  return f64::wetted(dry, f64::wet_part(ground.at.height, wet_height_), look_.refraction_index);
}

glm::dvec3 Tracer::light_of_ground(const SeenGround& ground, const f64::LightAt& at) const {
  return f64::ground_light(albedo_of(ground), ground.normal, at, shade_at(ground.radius * ground.up), light_);
}

glm::dvec3 Tracer::light_from_below(const Ray& refracted, const f64::LightAt& at, double shade) const {
  const auto way = ground_ ? ground_->hit(refracted, infinity, resolution_from(refracted.origin)) : std::nullopt;
  if (!way) return f64::light_through(glm::dvec3(0.0), at.up, bottomless, bottomless, at, shade, look_, light_);
  SeenGround bottom = ground_at(refracted.at(*way));
  bottom.at.height = std::min(bottom.at.height, 0.0);
  const glm::dvec3 albedo = albedo_of(bottom);
  const double depth = -bottom.at.height;
  const glm::dvec3 light = f64::light_through(albedo, bottom.normal, depth, *way, at, shade, look_, light_);
  const glm::dvec3 sunlight = f64::sunlight_through(albedo, bottom.normal, depth, *way, at, shade, look_, light_);
  return light + (gathered_on(bottom) - 1.0) * sunlight;
}

double Tracer::gathered_on(const SeenGround& bottom) const {
  const glm::dvec3 down = f64::refracted_ray(-light_.sun, bottom.up, look_);
  const double way = -bottom.at.height / f64::dive_of(down, bottom.up);
  return sea_->gathered_at(glm::normalize(bottom.up - way * down), way, look_.refraction_index);
}

f64::SceneLight Tracer::light_seen_from(const glm::dvec3& place) const {
  f64::SceneLight light = light_;
  light.eye = place;
  light.eye_height = glm::length(place) - 1.0;
  return light;
}

glm::dvec3 Tracer::sky_from(const Ray& ray, const f64::LightAt& at) const {
  const glm::dvec3 sky = f64::sky_along(at, ray.direction, light_);
  const double way = clouds_ ? f64::way_to_clouds(ray.origin, ray.direction, clouds_->clouds()) : 0.0;
  if (way <= 0.0) return sky;
  const f64::CloudAt cloud = clouds_->at(glm::normalize(ray.at(way)), light_.sun);
  const f64::SceneLight from_there = light_seen_from(ray.origin);
  return behind(f64::cloud_veil(cloud, way * ray.direction, clouds_->clouds(), from_there), sky);
}

glm::dvec3 Tracer::light_above(const Ray& ray, const f64::LightAt& at) const {
  if (const auto t = ground_ ? ground_->hit(ray, infinity, resolution_from(ray.origin)) : std::nullopt) {
    const SeenGround ground = ground_at(ray.at(*t));
    // Before a place under water there are other waves, which mirror the sky in turn.
    if (ground.at.height > 0.0) {
      const f64::LightAt there = light_over(ground);
      return f64::through_air(light_of_ground(ground, there), there, *t * ray.direction, light_seen_from(ray.origin));
    }
  }
  return sky_from(ray, at);
}

glm::dvec3 Tracer::light_of_water(const Ray& ray, const SeenWater& water, const f64::LightAt& at) const {
  const double shade = shade_at(water.at.still * sea_->still_radius());
  const glm::dvec3 refracted = f64::refracted_ray(ray.direction, water.look.normal, look_);
  const glm::dvec3 below = light_from_below({water.at.place, refracted}, at, shade);
  const glm::dvec3 mirrored = light_above({water.at.place, glm::reflect(ray.direction, water.look.normal)}, at);
  return f64::water_light(water.look, at, ray.direction, below, mirrored, shade, look_, light_);
}

glm::dvec3 Tracer::light_of_water_below(const Ray& ray, const SeenWater& water, const f64::LightAt& at) const {
  const double shade = shade_at(water.at.still * sea_->still_radius());
  f64::Water look = water.look;
  look.facing = -look.normal;
  const glm::dvec3 mirrored = light_from_below({water.at.place, glm::reflect(ray.direction, look.facing)}, at, shade);
  const glm::dvec3 above = light_above({water.at.place, f64::ray_above(ray.direction, look.facing, look_)}, at);
  return f64::water_light_below(look, at, ray.direction, above, mirrored, shade, look_, light_);
}

glm::dvec3 Tracer::light_in_water(const Ray& ray, const std::optional<Surface>& surface) const {
  const double eye_radius = glm::length(pose_.eye);
  const f64::LightAt over_eye = f64::light_at(pose_.eye / eye_radius, 0.0, light_);
  glm::dvec3 light(0.0);
  double way = bottomless;
  if (surface) {
    way = glm::distance(ray.at(surface->distance), pose_.eye);
    if (const SeenGround* ground = std::get_if<SeenGround>(&surface->what)) {
      const f64::LightAt at = light_over(*ground);
      const double shade = shade_at(ground->radius * ground->up);
      light =
          light_of_ground(*ground, at) +
          (gathered_on(*ground) - 1.0) * f64::ground_sunlight(albedo_of(*ground), ground->normal, at, shade, light_);
      light *= f64::left_at_depth(-ground->at.height, at, look_, light_);
    } else {
      const SeenWater& water = std::get<SeenWater>(surface->what);
      light = light_of_water_below(ray, water, f64::light_at(water.at.still, 0.0, light_));
    }
  }
  const double depth = std::max(sea_->still_radius() - eye_radius, 0.0);
  const double shade = shade_at(sea_->still_radius() * over_eye.up);
  return f64::through_water(light, depth, glm::dot(ray.direction, over_eye.up), way, over_eye, shade, look_, light_);
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

Sample Tracer::geometry(const glm::dvec2& pixel) const {
  const Ray ray = ray_of(pixel);
  return measured(ray, surface_along(ray));
}

Sample Tracer::sample(const glm::dvec2& pixel) const {
  const Ray ray = ray_of(pixel);
  const std::optional<Surface> surface = surface_along(ray);
  Sample sample = measured(ray, surface);
  if (begins_in_water(ray)) {
    sample.light = light_in_water(ray, surface);
    return sample;
  }
  glm::dvec3 light;
  if (surface) {
    const glm::dvec3 way = surface->distance * ray.direction;
    if (const SeenGround* ground = std::get_if<SeenGround>(&surface->what)) {
      const f64::LightAt at = light_over(*ground);
      light = f64::through_air(light_of_ground(*ground, at), at, way, light_);
    } else {
      const SeenWater& water = std::get<SeenWater>(surface->what);
      const f64::LightAt at = f64::light_at(water.at.still, 0.0, light_);
      light = f64::through_air(light_of_water(ray, water, at), at, way, light_);
    }
  } else {
    light = light_of_sky(ray);
  }
  const double depth = surface ? surface->distance * glm::dot(ray.direction, pose_.forward) : infinity;
  light += small_lights_.at(pixel, depth);
  sample.light = before_veils(ray, sample.distance, light);
  if (pose_.over_water > 0.0) sample.light += glare(ray);
  return sample;
}

}  // namespace terrella::reference
