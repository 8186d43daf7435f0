#include "planet/validity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/text.hpp"
#include "planet/icosphere.hpp"
#include "planet/spheres.hpp"
#include "planet/terrain.hpp"
#include "planet/waves.hpp"

namespace terrella {
namespace {

// Planet radii. Higher ground moves by more than a hundredth of a pixel against the camera (at 10 radii: 0.03), and so
// does a higher sea (at 10000 radii: 0.15).
constexpr double most_terrain_height = 3.0;
constexpr double most_water_level = 100.0;

// Cells of noise, or waves, on an edge of the mesh.
constexpr double most_cells_on_edge = 0.25;

// Pixels by which waves may be missed, root of the mean square, as a multiple of quality.pixel_error; as much as
// triangles of the ground may miss finer ones by. Then a picture is 28 dB from that of a mesh twice as fine (measured
// on storm without its ground); beyond, crests lie elsewhere.
constexpr double waves_missed = 2.5;

// Cells on a texel of the map of the clouds: with half of one, nothing of them is left.
constexpr double most_cells_on_texel = 0.3;

// Planet radii by which what water carries swims under a moving camera, because single precision places no finer.
constexpr double waves_swim = 6e-7, ripples_swim = 2e-7;
constexpr double most_swim = 0.1;  // pixels

// Phases (rad) larger than this are known to less than a hundredth, in double precision.
constexpr double most_phase = 1e13;

std::string number(double value) { return printed_number(value, 3); }

void judge_camera(const Scene& scene, const Pose& pose, std::vector<Issue>& issues) {
  if (!pose.raised) return;
  const double radius = scene.planet.radius;
  const double over = radius * (1.0 - glm::length(pose.eye) + pose.clearance) + scene.camera.altitude;
  issues.push_back({"camera.altitude", over < 0.0
                                           ? "the camera was under the surface and was raised above it."
                                           : text_of("the camera comes no nearer to the surface than ",
                                                     number(least_clearance(scene) * radius), " m on this planet.")});
}

void judge_heights(const Scene& scene, const Needs& needs, std::vector<Issue>& issues) {
  const double radius = scene.planet.radius;
  if (needs.ground != Ground::none && scene.terrain.height > most_terrain_height * radius) {
    issues.push_back({"terrain.height", text_of(number(scene.terrain.height), " m is more than the mesh of the ground ",
                                                "holds still under a moving camera; it does up to ",
                                                number(most_terrain_height * radius), " m on this planet.")});
  }
  if (needs.water != Water::none && scene.water.level > most_water_level * radius) {
    issues.push_back({"water.level", text_of(number(scene.water.level), " m is more than the mesh of the sea holds ",
                                             "still under a moving camera; it does up to ",
                                             number(most_water_level * radius), " m on this planet.")});
  }
}

// The part of a relief that triangles miss. Measured, of hills and of waves alike: a seventh with a quarter of a cell
// on an edge, 0.4 with a third, all with a half.
double missed_part(double cells_on_edge) {
  const double beyond = (cells_on_edge - most_cells_on_edge) / most_cells_on_edge;
  return std::clamp((1.0 + 6.0 * beyond) / 7.0, 0.0, 1.0);
}

void judge_ground(const Scene& scene, const Pose& pose, const Needs& needs, std::vector<Issue>& issues) {
  const auto& terrain = scene.terrain;
  if (lacks_real_size(scene)) {
    issues.push_back({"terrain.model",
                      "planets of real size need a program of their own; as long as it is not here, the ground near "
                      "the eye is coarse."});
    return;
  }
  const bool relief =
      needs.ground == Ground::icosphere && terrain.octaves > 0 && !terrain.map.map;  // nodes grow as fine as it takes
  const double may_be_missed = scene.quality.pixel_error * pixel_of_height(pose);
  const double edge = icosphere_edge(needs.ground_level), most = most_cells_on_edge / edge;
  const double missed = missed_part(terrain.frequency * edge);
  const bool shows = missed * terrain.height / scene.planet.radius > may_be_missed;
  if (!relief || !shows || terrain.frequency <= most) return;
  issues.push_back(
      {"terrain.frequency",
       text_of(number(terrain.frequency), " cells in a radius are more than the mesh ",
               "of the ground can raise; it does up to ", number(most), ", finer hills are flat and only shaded.")});
}

void judge_map(const Scene& scene, std::vector<Issue>& issues) {
  const MapFile& file = scene.terrain.map;
  if (file.name.empty() || file.map) return;
  issues.push_back({"terrain.map", text_of(json_quoted(shortened(file.name)),
                                           " is not here; drop the file on the planet. Until then its continents are "
                                           "those of the seed.")});
}

void judge_clouds(const Scene& scene, const Pose& pose, const Needs& needs, std::vector<Issue>& issues) {
  const bool in_pixels = needs.cloud_pixel_end > needs.cloud_pixel_first;  // what the map can't hold
  if (needs.clouds == Clouds::none || in_pixels) return;
  const double pixel = pose.pixel_angle * std::abs(glm::length(pose.eye) - cloud_radius(scene));
  const bool shows = scene.clouds.frequency * pixel < 0.5;
  const double most = most_cells_on_texel / texel_angle(needs.cloud_texels);
  if (!shows || scene.clouds.frequency <= most) return;
  issues.push_back({"clouds.frequency",
                    text_of(number(scene.clouds.frequency), " cells in a radius are more than the map of the clouds ",
                            "can hold; it does up to ", number(most), " with quality.cloud_texels ", needs.cloud_texels,
                            ", finer clouds fade away.")});
}

// That run around the whole planet.
void judge_number_of_waves(const Scene& scene, const Needs& needs, std::vector<Issue>& issues) {
  if (needs.water != Water::waves) return;
  const int around = has_nodes(needs.ground) ? static_cast<int>(make_sea(scene, 0.0).waves.size()) : scene.waves.count;
  if (around <= most_long_waves) return;
  issues.push_back({"waves.count",
                    text_of("no more than ", most_long_waves, " waves run around a whole planet; more are left out.")});
}

void judge_waves(const Scene& scene, const Pose& pose, const Needs& needs, std::vector<Issue>& issues) {
  if (needs.water != Water::waves || has_nodes(needs.ground)) return;
  const double edge = icosphere_edge(needs.water_level), least = edge / most_cells_on_edge;
  double shortest = std::numeric_limits<double>::infinity(), missed_squares = 0.0;
  for (const f64::Wave& wave : make_sea(scene, 0.0).waves) {
    const double length = 2.0 * std::numbers::pi / wave.wavenumber;
    shortest = std::min(shortest, length);
    missed_squares += 0.5 * std::pow(missed_part(edge / length) * wave.amplitude, 2);
  }
  const bool shows = std::sqrt(missed_squares) > waves_missed * scene.quality.pixel_error * pixel_of_height(pose);
  if (!shows || shortest >= least) return;
  const double radius = scene.planet.radius;
  issues.push_back({is_of_wind(scene) ? "waves.shortest" : "waves.length",
                    text_of("the shortest of the waves have ", number(shortest * radius),
                            " m, which is less than the mesh of the sea can raise; it does from ",
                            number(least * radius), " m on, shorter ones are flat and only shaded.")});
}

void judge_water(const Scene& scene, const View& view, const Pose& pose, const Needs& needs,
                 std::vector<Issue>& issues) {
  const bool waves = needs.water == Water::waves, ripples = needs.ripple_layers > 0;
  if ((waves && !has_nodes(needs.ground)) || ripples) {
    const double nearest = (waves ? waves_swim : ripples_swim) / most_swim / pose.pixel_angle;
    if (pose.nearest < nearest) {
      const double radius = scene.planet.radius;
      issues.push_back({"camera.altitude",
                        text_of(number(pose.nearest * radius), " m over the surface ", waves ? "waves" : "ripples",
                                " swim by more than a tenth of a pixel when the camera moves; they hold from ",
                                number(nearest * radius), " m on.")});
    }
  }
  // Shorter waves are slower, but turn faster: by the root of their length, of which the shortest have a sixth.
  const auto& w = scene.waves;
  const double turns_at_once = std::abs(view.seconds) * 2.0 * std::numbers::pi / w.length;
  const double fastest = most_phase / std::max(1e-300, turns_at_once * std::sqrt(w.count > 1 ? 6.0 : 1.0));
  if (waves && !is_of_wind(scene) && w.speed > fastest) {
    issues.push_back(
        {"waves.speed", text_of(number(w.speed), " m/s is more than can be followed for ", number(view.seconds),
                                " s; up to ", number(fastest), " m/s waves of this length move as they should.")});
  }
}

}  // namespace

std::vector<Issue> beyond_validity(const Scene& scene, const View& view, const Pose& pose, const Needs& needs) {
  std::vector<Issue> issues;
  judge_camera(scene, pose, issues);
  judge_heights(scene, needs, issues);
  judge_ground(scene, pose, needs, issues);
  judge_map(scene, issues);
  judge_clouds(scene, pose, needs, issues);
  judge_number_of_waves(scene, needs, issues);
  judge_waves(scene, pose, needs, issues);
  judge_water(scene, view, pose, needs, issues);
  return issues;
}

}  // namespace terrella
