#include "planet/water_medium.hpp"

#include "scene/choices.hpp"

namespace terrella {
namespace {

// Absorption of pure water (Pope and Fry 1997) with what is dissolved and floats in each kind; backscattering between
// that of pure sea water (Morel 1974) and of turbid coasts. No one has been to the sea of an alien world.
constexpr WaterMedium clear_ocean = {{0.27, 0.060, 0.017}, {0.0008, 0.0014, 0.0026}};
constexpr WaterMedium coastal = {{0.33, 0.12, 0.16}, {0.009, 0.011, 0.012}};
constexpr WaterMedium lagoon = {{0.27, 0.065, 0.040}, {0.005, 0.008, 0.011}};
constexpr WaterMedium alien = {{0.03, 0.35, 0.12}, {0.012, 0.010, 0.015}};

// Of the particles of the sea, which are of all sizes: by one over the length of a wave of light, an empirical law.
constexpr glm::dvec3 of_particles = {550.0 / 610.0, 1.0, 550.0 / 465.0};

}  // namespace

std::optional<WaterMedium> medium_of(const Scene& scene) {
  const auto& water = scene.water;
  switch (water.medium) {
    case choice("water.medium", "clear_ocean"): return clear_ocean;
    case choice("water.medium", "coastal"): return coastal;
    case choice("water.medium", "lagoon"): return lagoon;
    case choice("water.medium", "alien"): return alien;
    case choice("water.medium", "measured"):
      return WaterMedium{{water.absorption_red, water.absorption_green, water.absorption_blue},
                         water.scattering * of_particles};
    default: return std::nullopt;
  }
}

glm::dvec3 extinction_of(const WaterMedium& medium) { return medium.absorption + medium.backscattering; }

glm::dvec3 color_of_depths(const WaterMedium& medium) { return 0.33 * medium.backscattering / extinction_of(medium); }

}  // namespace terrella
