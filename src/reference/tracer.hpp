// What is seen along single rays: the scene itself, by the formulas of shaders/lib in double precision, without a mesh,
// a map or a level of detail. Lengths in planet radii.
#pragma once

#include <optional>
#include <variant>

#include "planet/pose.hpp"
#include "reference/cloud_layer.hpp"
#include "reference/footprints.hpp"
#include "reference/ground.hpp"
#include "reference/sea.hpp"
#include "reference/small_lights.hpp"
#include "scene/scene.hpp"

namespace terrella::reference {

// What is seen in a direction.
struct Sample {
  glm::dvec3 light{0.0};   // linear, before exposure
  double distance;         // from the eye; infinite for the sky
  glm::dvec3 normal{0.0};  // unit; 0 for the sky
  double height;           // over the unit sphere; infinite for the sky
};

// May be asked by several threads at once.
class Tracer {
 public:
  Tracer(const Scene& scene, const View& view, const Footprints& left_out = {});
  Tracer(const Tracer&) = delete;
  Tracer& operator=(const Tracer&) = delete;

  // pixel: from the top left of the picture, may be fractional.
  [[nodiscard]] Sample sample(const glm::dvec2& pixel) const;

  // The same without light, which takes most of the time.
  [[nodiscard]] Sample geometry(const glm::dvec2& pixel) const;

 private:
  struct SeenGround {
    double radius;
    glm::dvec3 up;
    glm::dvec3 normal;
    f64::GroundAt at;
  };
  struct SeenWater {
    WaterAt at;
    f64::Water look;
  };
  struct Surface {
    double distance;  // along the ray
    std::variant<SeenGround, SeenWater> what;
  };

  // From the eye, or where that may dive, from the lens.
  [[nodiscard]] Ray ray_of(const glm::dvec2& pixel) const;
  [[nodiscard]] bool begins_in_water(const Ray& ray) const;
  [[nodiscard]] std::optional<Surface> surface_along(const Ray& ray) const;
  // The shortest pieces that a ray beside the eye's is looked at in.
  [[nodiscard]] Resolution resolution_from(const glm::dvec3& place) const;
  // place: on the ground.
  [[nodiscard]] SeenGround ground_at(const glm::dvec3& place) const;
  [[nodiscard]] SeenWater water_at(const glm::dvec3& place, bool from_below) const;
  [[nodiscard]] Sample measured(const Ray& ray, const std::optional<Surface>& surface) const;
  [[nodiscard]] double shade_at(const glm::dvec3& place) const;
  [[nodiscard]] f64::LightAt light_over(const SeenGround& ground) const;
  [[nodiscard]] glm::dvec3 albedo_of(const SeenGround& ground) const;
  // at: there.
  [[nodiscard]] glm::dvec3 light_of_ground(const SeenGround& ground, const f64::LightAt& at) const;
  [[nodiscard]] glm::dvec3 light_of_water(const Ray& ray, const SeenWater& water, const f64::LightAt& at) const;
  [[nodiscard]] glm::dvec3 light_from_below(const Ray& refracted, const f64::LightAt& at, double shade) const;
  // Along a ray from the water up.
  [[nodiscard]] glm::dvec3 light_above(const Ray& ray, const f64::LightAt& at) const;
  // What lights the scene, and the air, for an eye at another place.
  [[nodiscard]] f64::SceneLight light_seen_from(const glm::dvec3& place) const;
  [[nodiscard]] glm::dvec3 sky_from(const Ray& ray, const f64::LightAt& at) const;
  // Sunlight that waves gather on the bottom, as a multiple of what it has under a still sea.
  [[nodiscard]] double gathered_on(const SeenGround& bottom) const;
  [[nodiscard]] glm::dvec3 light_of_water_below(const Ray& ray, const SeenWater& water, const f64::LightAt& at) const;
  // As it is seen from within the water.
  [[nodiscard]] glm::dvec3 light_in_water(const Ray& ray, const std::optional<Surface>& surface) const;
  [[nodiscard]] glm::dvec3 light_of_sky(const Ray& ray) const;
  [[nodiscard]] glm::dvec3 before_veils(const Ray& ray, double distance, glm::dvec3 light) const;
  [[nodiscard]] glm::dvec3 glare(const Ray& ray) const;

  Scene scene_;
  View view_;
  Footprints left_out_;
  Pose pose_;
  f64::SceneLight light_;
  f64::Bands bands_;
  f64::WaterLook look_;
  glm::dvec3 lens_;  // lens_above_water
  bool in_water_;    // the lens, or a part of it
  double wet_height_;
  f64::Rings rings_;
  std::optional<Ground> ground_;
  std::optional<Sea> sea_;
  std::optional<CloudLayer> clouds_;
  SmallLights small_lights_;
  double piece_;  // of a ray that is not looked into, per distance: a part of a pixel
  double water_level_;
  double top_radius_;  // on which the rings' shadow is drawn
  double sun_pixel_;   // size of a pixel where the sun stands, rad
  double free_sun_;    // part of the sun's disc that the planet leaves free
};

}  // namespace terrella::reference
