#include "measure/ground_views.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include <glm/trigonometric.hpp>

#include "formulas/formulas.hpp"
#include "planet/pose.hpp"

namespace terrella {
namespace {

constexpr std::array altitudes = {10.0, 100.0, 1e3, 1e4, 1e5, 1e6, 1e7, 4e7};

struct Place {
  std::string_view preset;
  double latitude, longitude, heading;  // deg
};

// On land, among mountains.
constexpr std::array places_of_presets = {
    Place{"blue", -41.3, 131.5, 0.0},
    Place{"highlands", -41.3, 131.5, 0.0},
    Place{"giant", 15.0, 117.0, 0.0},
};

}  // namespace

std::span<const double> measured_altitudes() { return altitudes; }

Scene seen_from(const SceneDocument& document, double altitude) {
  constexpr double field = 60.0, horizon_over_middle = 12.0, far_away = 60.0;  // deg
  Scene scene = document.scene;
  auto& camera = scene.camera;
  const auto place = std::find_if(places_of_presets.begin(), places_of_presets.end(),
                                  [&](const Place& known) { return known.preset == document.preset; });
  if (place != places_of_presets.end()) {
    camera.latitude = place->latitude;
    camera.longitude = place->longitude;
    camera.heading = place->heading;
  }
  const double radius = scene.planet.radius;
  const double surface = surface_radius(scene, direction_of(camera.latitude, camera.longitude));
  camera.altitude = (surface - 1.0) * radius + altitude;
  // By how much the horizon lies below the level.
  const double dip = glm::degrees(std::acos(1.0 / (1.0 + altitude / radius)));
  camera.pitch = dip < far_away ? -(dip + horizon_over_middle) : -90.0;
  camera.roll = 0.0;
  camera.fov = field;
  return scene;
}

}  // namespace terrella
