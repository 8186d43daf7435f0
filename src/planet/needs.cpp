#include "planet/needs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "base/text.hpp"
#include "formulas/formulas.hpp"
#include "planet/icosphere_groups.hpp"
#include "planet/lights.hpp"
#include "planet/materials.hpp"
#include "planet/node_ranges.hpp"
#include "planet/octaves.hpp"
#include "planet/real_size.hpp"
#include "planet/rings.hpp"
#include "planet/shores.hpp"
#include "planet/spheres.hpp"
#include "planet/sun.hpp"
#include "planet/terrain.hpp"
#include "planet/waves.hpp"

namespace terrella {
namespace {

// Places in the choice lists of params.inc.
enum : int { model_none = 0, model_auto = 1, water_calm = 2, water_waves = 3 };

// In the order of the choices of water.shading.
enum : int { shading_phong = 1 };

// In the order of the choices of terrain.model.
enum : int { ground_icosphere = 2, ground_triangle_lod = 4 };

// A planet that is large for who stands on it, and whose mountains are low beside it.
constexpr double real_radius = 10e3, real_relief = 0.02;  // m; planet radii

// As much of what lies between two surfaces as a mesh may miss either by.
constexpr double of_gap = 0.3;

std::string number(double value) { return printed_number(value, 4); }

class Decisions {
 public:
  explicit Decisions(std::vector<Decision>& list) : list_(list) {}

  void add(const char* what, std::string_view chosen, std::string why) {
    list_.push_back({what, std::string(chosen), std::move(why)});
  }
  void add(const char* what, double chosen, std::string why) { add(what, number(chosen), std::move(why)); }

 private:
  std::vector<Decision>& list_;
};

// Of the sea, or cracks of its crust, which are of the same noise.
bool has_ripples(const Scene& scene) { return scene.water.ripples > 0.0 || scene.water.crust > 0.0; }

bool clouds_move(const Scene& scene) {
  return has_clouds(scene) && (scene.clouds.drift != 0.0 || scene.clouds.speed > 0.0);
}

// Of meshes that carry a relief. A mesh finer than level 6 is worth its triangles only to someone who asks for less
// than a fifth of a pixel, and one finer than level 7 for less than a tenth.
int finest_relief_level(const Scene& scene) {
  return scene.quality.pixel_error < 0.1 ? 8 : scene.quality.pixel_error < 0.2 ? 7 : 6;
}

// The coarsest icosphere that shows a sphere within an error (radii).
int sphere_level(double allowed) {
  constexpr int finest = 6;
  int level = group_level;
  while (level < finest && icosphere_edge(level) * icosphere_edge(level) / 8.0 > allowed) ++level;
  return level;
}

// About how far (pixels) flat triangles between the vertices of nodes miss the ground in all but a hundredth of places,
// as steep as they are most of the way up; among the highest mountains it is more. Pictures miss it by less, as pixels
// go on to the ground that they know: by two thirds of that (tests/measure/node_errors_test.cpp). apart: vertices to a
// distance.
double error_of_nodes(const Scene& scene, double pixel_angle, double apart) {
  constexpr double of_deviation = 3.3, nearest = 1e-7, farthest = 2.0;  // planet radii
  double most = 0.0;
  for (double distance = nearest; distance < farthest; distance *= 4.0) {
    const double spacing = apart * distance, pixel = pixel_angle * distance;
    const double missed = of_deviation * unseen_heights(scene, spacing, 0.5 * pixel) + spacing * spacing / 8.0;
    most = std::max(most, missed / pixel);
  }
  return most;
}

// Cells along a side of nodes, at the most: of a persistent grid's, which are divided further away, there would be no
// room for as many of the largest.
int most_cells_of(Ground ground) { return ground == Ground::persistent_grid ? most_cells - 2 : most_cells; }

unsigned sides_of_nodes(Ground ground) { return ground == Ground::triangle_lod ? 3 : 4; }

// How far apart vertices of nodes are, as a part of their distance.
double part_between_vertices(double split, int cells) {
  constexpr double mean_distance = 1.4;  // of a node, of that at which it is split
  return 1.0 / (mean_distance * split * cells);
}

// How far from the eye nodes can be split, of those that there is room for: eyes at the ground, which need most, need
// about so many for each square of that.
double most_split(const Needs& needs) {
  constexpr double of_triangles = 350.0, of_squares = 167.0;
  const unsigned sides = sides_of_nodes(needs.ground);
  const int room = node_room(vertices_of_patch(sides, needs.ground_cells));
  return std::min(std::sqrt(room / (sides == 3 ? of_triangles : of_squares)), 3.5);
}

// Nodes of as few cells as show the ground in a picture of usual size. What picture is drawn in truth only tells how
// far from the eye they are split: other cells would mean to make all of them anew, while a window is resized or its
// view narrowed. Neither depends on where the eye is.
void decide_fineness(Needs& needs, const Scene& scene, const Pose& pose) {
  constexpr double usual_pixel = 2.0 * 0.414 / 720.0;  // rad, of 45 degrees
  const auto is_enough = [&](double split, int cells, double pixel_angle) {
    return error_of_nodes(scene, pixel_angle, part_between_vertices(split, cells)) <= scene.quality.pixel_error;
  };
  const double least = least_split(sides_of_nodes(needs.ground) == 3 ? 1.0 : std::numbers::sqrt2);
  for (int cells = least_cells; cells <= most_cells_of(needs.ground); cells += 2) {
    needs.ground_cells = cells;
    if (is_enough(least, cells, usual_pixel)) break;
  }
  needs.ground_split = least;
  const double most = most_split(needs);
  while (needs.ground_split < most && !is_enough(needs.ground_split, needs.ground_cells, pose.pixel_angle)) {
    needs.ground_split += 0.0625;
  }
}

// Nodes, and what pixels add to their vertices.
[[maybe_unused]] void decide_nodes(Needs& needs, const Scene& scene, const Pose& pose, Decisions& decide) {
  const auto& terrain = scene.terrain;
  decide_fineness(needs, scene, pose);
  decide.add("ground.cells", needs.ground_cells,
             "along a side of a node: as few as quality.pixel_error allows in a picture of 720 rows");
  decide.add("ground.split", needs.ground_split,
             "edges of a node within which it is split in four: more where its cells are not enough for the picture");
  const double finest = terrain.frequency * std::pow(terrain.lacunarity, std::max(terrain.octaves - 1, 0));
  // Flat triangles so small miss the finest hills by less than a ten thousandth of their height, also for who stands
  // there.
  needs.ground_finest = std::max(0.008 / finest, 2.0 * finest_footprint);
  if (terrain.map.map) needs.ground_finest = std::min(needs.ground_finest, 0.5 * terrain.map.map->texel());
  decide.add("ground.finest", needs.ground_finest * scene.planet.radius,
             "m between vertices, which shows the finest layer of noise: no closer anywhere");
  constexpr double coarsest_spacing = 0.2;  // about that of undivided nodes of the fewest cells
  needs.ground_spacing =
      std::clamp(part_between_vertices(needs.ground_split, needs.ground_cells) * lift_over(pose.nearest),
                 std::min(needs.ground_finest, coarsest_spacing), coarsest_spacing);
  needs.pixel_octaves_end = visible_octaves(terrain.frequency, terrain.lacunarity, terrain.octaves,
                                            std::max(footprint_below(scene, pose), finest_footprint));
  decide.add("ground.pixel_octaves", needs.pixel_octaves_end, "pixels add those that vertices can't hold");
}

void decide_map(Needs& needs, const Scene& scene, Decisions& decide) {
  const MapFile& file = scene.terrain.map;
  needs.ground_mapped = file.map != nullptr;
  if (file.name.empty() && !needs.ground_mapped) return;
  decide.add("ground.map", needs.ground_mapped ? file.name : "none",
             needs.ground_mapped ? text_of("terrain.map has the continents; layers of noise from the ",
                                           first_layer(scene) + 1, ". on are finer than its texels")
                                 : "terrain.map names a file that is not here: the continents are the seed's");
}

void decide_ground(Needs& needs, const Scene& scene, const Pose& pose, Decisions& decide) {
  const auto& terrain = scene.terrain;
  if (terrain.model == model_none) return decide.add("ground", name_of(needs.ground), "terrain.model asks for none");
  needs.ground = ground_technique(scene);
  decide.add("ground", name_of(needs.ground),
             terrain.model > 1 ? "terrain.model asks for it"
             : needs.ground == Ground::icosphere
                 ? "a miniature: one mesh shows all of it"
                 : "the planet is of real size, from 10 km of radius on with mountains below a fiftieth of it: of the "
                   "three ways to divide it the one with the fewest triangles for the same error, and the fastest");
  decide_map(needs, scene, decide);
  if (has_real_size && has_nodes(needs.ground)) return decide_nodes(needs, scene, pose, decide);

  needs.ground_level = ground_level(scene);
  decide.add("ground.level", needs.ground_level,
             "the coarsest mesh within quality.pixel_error, and no finer than level 6, or 7 where that is below 0.2 "
             "px, 8 below 0.1");
  needs.ground_spacing = icosphere_edge(needs.ground_level);
  // In steps, so that the triangles do not change with every move of the camera.
  const double allowed = scene.quality.pixel_error * pixel_of_height(pose);
  needs.ground_tolerance = std::exp2(0.25 * std::floor(4.0 * std::log2(allowed)));
  decide.add("ground.tolerance", needs.ground_tolerance * scene.planet.radius,
             "m by which triangles may miss finer ones: quality.pixel_error where it shows most");
  needs.ground_texels = scene.quality.ground_texels;
  decide.add("ground.texels", needs.ground_texels, "quality.ground_texels");

  const double texel = texel_angle(needs.ground_texels);
  const double pixel = footprint_below(scene, pose);
  const int shown = visible_octaves(terrain.frequency, terrain.lacunarity, terrain.octaves, pixel);
  const int held = octaves_below(0.25, terrain.frequency, terrain.lacunarity, terrain.octaves, texel);
  const int first = std::max(held, first_layer(scene));
  const bool near_enough = pixel * scene.quality.ground_texel_size < texel && terrain.height > 0.0;
  needs.pixel_octaves_first = first;
  needs.pixel_octaves_end = near_enough ? std::max(first, shown) : first;
  decide.add("ground.pixel_octaves", needs.pixel_octaves_end - first,
             near_enough ? "so near, pixels show layers that the map of the ground can't hold"
                         : "no texel of the map of the ground is larger than quality.ground_texel_size");
}

// From afar two layers; from close by, where each shows few ripples, finer ones between them. pixel: its footprint,
// rad.
int ripple_layers(double frequency, double pixel) {
  constexpr int least = 2, most = 8;
  constexpr double finest = 5e5;  // of which single precision places cells on the sphere to a thirtieth
  int layers = least;
  for (double f = frequency * 2.3 * 2.3; layers < most && f < finest && 1.0 / f > 4.0 * pixel; f *= 2.3) ++layers;
  return layers;
}

void decide_ripples(Needs& needs, const Scene& scene, const Pose& pose, Decisions& decide) {
  const auto& water = scene.water;
  const bool calm = needs.water == Water::calm && !needs.hides_waves;
  const bool wanted = calm && has_ripples(scene);
  const double pixel = footprint_below(scene, pose);
  const bool seen = 1.0 / water.ripple_frequency > 2.0 * pixel;
  if (wanted && seen) needs.ripple_layers = ripple_layers(water.ripple_frequency, pixel);
  decide.add("water.ripples", needs.ripple_layers,
             !calm     ? "a sea of waves has no other ripples"
             : !wanted ? "water.ripples and water.crust are 0"
             : seen    ? "two layers, and finer ones where their ripples are twice as large as quality.finest_layer"
                       : "a ripple is smaller than quality.finest_layer: it only widens the glitter");
}

// What the eye sees from within the water.
void decide_dive(Needs& needs, const Scene& scene, const View& view, const Pose& pose, Decisions& decide) {
  if (!scene.water.dive) return;
  needs.in_water = is_in_water(pose, view);
  if (is_all_in_water(pose, view)) {
    // Less than a thousandth of any colour is left there.
    const glm::dvec3 extinction = water_look_of(scene).extinction;
    needs.water_sight = 7.0 / std::max(std::min({extinction.x, extinction.y, extinction.z}), 1e-9);
  }
  decide.add("water.seen_from",
             needs.water_sight > 0.0 ? "below"
             : needs.in_water        ? "both"
                                     : "above",
             needs.water_sight > 0.0 ? "water.dive: the eye is under water"
             : needs.in_water        ? "water.dive: the surface passes over the lens"
                                     : "the eye is over the water");
}

// Land that is seen in the water's mirror. It fades in, so that no one sees it come.
void decide_mirror(Needs& needs, const Scene& scene, const Pose& pose, Decisions& decide) {
  constexpr double usual_height = 0.1, usual_grazing = 0.1;  // of land's highest; rad
  const double over_water = glm::length(pose.eye) - water_radius(scene);
  const double pixel = pose.pixel_angle * std::max(over_water, 0.0) / usual_grazing;
  const double height = usual_height * (ground_top(scene) - water_radius(scene));
  const bool near = has_nodes(needs.ground) || refines_ground(needs);
  const bool fresnel = scene.water.shading != shading_phong;
  if (near && fresnel && over_water > 0.0 && height > pixel) needs.mirrored_land = std::min(height / pixel - 1.0, 1.0);
  decide.add("water.mirrored_land", needs.mirrored_land,
             needs.mirrored_land > 0.0 ? "shores are near enough for land to be seen in the water"
             : !fresnel                ? "water.shading asks for a highlight alone"
             : over_water <= 0.0       ? "the eye is under water"
                                       : "there is no land near enough to be seen in the water");
}

void decide_water(Needs& needs, const Scene& scene, const View& view, const Pose& pose, Decisions& decide) {
  const auto& water = scene.water;
  if (!has_water(scene)) {
    return decide.add("water", name_of(needs.water),
                      water.model == model_none ? "water.model asks for none" : "water.level is 0");
  }
  const Sea sea = make_sea(scene, 0.0);
  const double pixel = std::max(pose.pixel_angle * pose.nearest, 1e-12);
  const bool nodes = has_nodes(needs.ground);
  if (water.model == water_calm) {
    needs.water = Water::calm;
    decide.add("water", name_of(needs.water), "water.model asks for it");
  } else if (nodes ? sea.is_calm() : sea.waves.empty()) {
    needs.water = Water::calm;
    decide.add("water", name_of(needs.water), "no waves are asked for");
  } else if (nodes && longest_wave(sea) < 2.0 * footprint_below(scene, pose) && water.model != water_waves) {
    needs.water = Water::calm;
    decide.add("water", name_of(needs.water),
               "the longest wave is smaller than quality.finest_layer: it roughens the water");
  } else if (!nodes && sea.highest < scene.quality.wave_height * pixel && water.model != water_waves) {
    needs.water = Water::calm;
    decide.add("water", name_of(needs.water), "the highest wave is lower than quality.wave_height");
  } else {
    needs.water = Water::waves;
    decide.add("water", name_of(needs.water), "waves are asked for and can be seen");
    decide.add("waves.steepness", sea.steepness,
               sea.held ? "held where the surface would fold over" : "as asked; the surface does not fold");
  }
  decide_dive(needs, scene, view, pose, decide);
  decide_mirror(needs, scene, pose, decide);
  needs.hides_waves = nodes && needs.water == Water::calm && !sea.is_calm();
  const double allowed = scene.quality.pixel_error * pixel_of_water_height(pose);
  needs.water_level = needs.water == Water::waves ? finest_relief_level(scene) : sphere_level(allowed);
  decide.add("water.level", needs.water_level,
             nodes ? "of no use over a ground of nodes, whose vertices the sea takes"
             : needs.water == Water::waves
                 ? "waves need the finest mesh: level 6, or 7 with quality.pixel_error below 0.2, 8 below 0.1"
                 : "the coarsest sphere within quality.pixel_error, and no finer than level 6");
  // So that no flat triangle of the sea dips below one of the ground where both should meet: then the map, or the
  // pixels of nodes, draw the shore. Never so far that it nears the eye, which in the smallest pictures would not count
  // as an error.
  if (has_nodes(needs.ground)) {
    needs.water_lift = std::min(scene.quality.pixel_error * pose.pixel_angle, 0.05);
    needs.water_hides = needs.in_water ? 1.0 : hiding_depth(scene, sea);
    needs.sea_swell = needs.water == Water::waves ? sea.highest : 0.0;
    needs.water_most_lift = has_clouds(scene) ? of_gap * std::max(cloud_radius(scene) - water_radius(scene), 0.0) : 1.0;
  } else {
    needs.water_lift =
        std::min({icosphere_sag(needs.water_level) + needs.ground_tolerance, allowed, 0.05 * pose.nearest});
  }

  decide_ripples(needs, scene, pose, decide);
}

// By how much (rad) the coarsest layer of clouds may turn between two pictures that are blended. Half way between two
// gradients that are an angle apart, their mean is shorter by the cosine of half of it; layer i turns by 2^i times as
// much as the coarsest (flow_speed). The angle is such that all layers together lose a part of their amplitude that is
// small enough (quality.cloud_loss), and a whole one of the longest halved again and again: the moments of a short
// interval are those of longer ones as well.
double blend_turn(double persistence, int octaves, double may_be_lost) {
  const auto lost = [&](double turn) {
    double loss = 0.0, total = 0.0, amplitude = 1.0;
    for (int i = 0; i < octaves; ++i, amplitude *= persistence) {
      loss += amplitude * (1.0 - std::cos(std::min(0.5 * turn * f64::flow_speed(i), 0.5 * std::numbers::pi)));
      total += amplitude;
    }
    return loss / total;
  };
  double turn = longest_blend_turn;
  while (lost(turn) > may_be_lost) turn *= 0.5;
  return turn;
}

// From the clouds to the highest that lies whole under them (planet radii): mountains that pierce them do so anyway.
double gap_below_clouds(const Scene& scene) {
  const double clouds = cloud_radius(scene), sea = has_water(scene) ? water_radius(scene) : 1.0;
  double gap = std::abs(clouds - sea);
  for (const double top : {ice_top(scene), ground_top(scene)}) {
    if (top < clouds) gap = std::min(gap, clouds - top);
  }
  return gap;
}

void decide_clouds(Needs& needs, const Scene& scene, const Pose& pose, Decisions& decide) {
  const auto& clouds = scene.clouds;
  if (!has_clouds(scene)) {
    return decide.add("clouds", name_of(needs.clouds),
                      clouds.model == model_none ? "clouds.model asks for none"
                                                 : "coverage, density or octaves is 0: there is nothing to see");
  }
  needs.clouds = Clouds::shell;
  decide.add("clouds", name_of(needs.clouds), "the only model of clouds in this version");
  const double pixel = pose.pixel_angle * std::abs(glm::length(pose.eye) - cloud_radius(scene));
  // Nor may they dip into what lies under them, however small that is from afar, as far as the finest sphere can tell.
  needs.cloud_level = sphere_level(std::min(scene.quality.pixel_error * pixel, of_gap * gap_below_clouds(scene)));
  decide.add("clouds.level", needs.cloud_level,
             "the coarsest sphere within quality.pixel_error, and no finer than level 6");
  needs.cloud_texels = scene.quality.cloud_texels;
  const double footprint = std::max(texel_angle(needs.cloud_texels), footprint_below(scene, pose));
  needs.cloud_octaves = std::max(1, visible_octaves(clouds.frequency, 2.0, clouds.octaves, footprint));
  decide.add("clouds.octaves", needs.cloud_octaves,
             needs.cloud_octaves == clouds.octaves ? "as many as clouds.octaves asks for"
                                                   : "finer ones are under two texels of their map");
  // Beyond this frequency single precision places no cells.
  constexpr double highest_frequency = 1e5;
  const double texel = texel_angle(needs.cloud_texels);
  const double footprint_there = pixel * footprint_of_pixel(scene);
  const bool near_enough = footprint_there * scene.quality.cloud_texel_size < texel;
  const int shown =
      visible_octaves(clouds.frequency, 2.0, clouds.octaves, std::max(footprint_there, 0.5 / highest_frequency));
  const int first = octaves_below(0.3, clouds.frequency, 2.0, needs.cloud_octaves, texel);
  needs.cloud_pixel_first = first;
  needs.cloud_pixel_end = near_enough ? std::max(first, shown) : first;
  decide.add("clouds.pixel_octaves", needs.cloud_pixel_end - needs.cloud_pixel_first,
             near_enough ? "so near, pixels show layers that the map of the clouds can't hold"
                         : "no texel of the map of the clouds is larger than quality.cloud_texel_size");
  needs.cloud_interval =
      clouds.speed > 0.0 ? blend_turn(clouds.persistence, needs.cloud_octaves, scene.quality.cloud_loss) / clouds.speed
                         : 0.0;
  decide.add(
      "clouds.interval", needs.cloud_interval,
      clouds.speed > 0.0
          ? "seconds between two pictures of the clouds, so that blending them loses no more than quality.cloud_loss"
          : "clouds.speed is 0");
}

void decide_night(Needs& needs, const Scene& scene, Decisions& decide) {
  const bool lights = has_lights(scene);
  needs.night = lights ? NightSide::lights : NightSide::none;
  decide.add("night", name_of(needs.night),
             lights              ? "found once for a ground and drawn as points where it is dark"
             : has_ground(scene) ? "lights.density or brightness is 0: there is nothing to see"
                                 : "there is no ground for lights to stand on");
}

void decide_sun(Needs& needs, const Scene& scene, const View& view, const Pose& pose, Decisions& decide) {
  const bool shines = scene.sun.intensity > 0.0 && (scene.sun.size > 0.0 || scene.sun.glare > 0.0);
  const bool seen = shines && sun_in_picture(scene, view, pose, scene.sun.glare > 0.0);
  needs.sun = seen ? SunImage::disc : SunImage::none;
  decide.add("sun", name_of(needs.sun),
             seen     ? "the sun or its glare is in the picture"
             : shines ? "the sun is beside the picture"
                      : "sun.intensity, or both size and glare, are 0: there is nothing to see");
}

void decide_rings(Needs& needs, const Scene& scene, Decisions& decide) {
  const bool asked = scene.rings.density > 0.0;
  if (has_rings(scene)) needs.rings = Rings::plane;
  decide.add("rings", name_of(needs.rings),
             needs.rings != Rings::none ? "drawn in the plane of the equator, with their shadow"
             : asked                    ? "rings.outer is not greater than rings.inner: there is nothing to see"
                                        : "rings.density is 0: there is nothing to see");
}

void decide_rest(Needs& needs, const Scene& scene, Decisions& decide) {
  const bool air = has_air(scene);
  needs.air = air ? Air::fresnel : Air::none;
  decide.add("air", name_of(needs.air),
             air                             ? "the only model of air in this version"
             : scene.air.model == model_none ? "air.model asks for none"
                                             : "density or height is 0: there is nothing to see");
  const bool stars = has_stars(scene);
  needs.stars = stars ? Stars::noise : Stars::none;
  decide.add("stars", name_of(needs.stars),
             stars                             ? "found once and drawn as points"
             : scene.stars.model == model_none ? "stars.model asks for none"
                                               : "density or brightness is 0: there is nothing to see");
}

bool anything_moves(const Needs& needs, const Scene& scene) {
  if (scene.time.speed == 0.0) return false;
  const bool waves = needs.water == Water::waves && waves_run(scene);
  const bool ripples = needs.ripple_layers > 0 && scene.water.ripple_speed > 0.0;
  return clouds_move(scene) || waves || ripples;
}

}  // namespace

std::string_view name_of(Ground technique) {
  switch (technique) {
    case Ground::none: return "none";
    case Ground::icosphere: return "icosphere";
    case Ground::persistent_grid: return "persistent_grid";
    case Ground::triangle_lod: return "triangle_lod";
    case Ground::quadtree: return "quadtree";
  }
  return "";
}
std::string_view name_of(Water technique) {
  return technique == Water::none ? "none" : technique == Water::calm ? "calm" : "waves";
}
std::string_view name_of(Clouds technique) { return technique == Clouds::none ? "none" : "shell"; }
std::string_view name_of(Air technique) { return technique == Air::none ? "none" : "fresnel"; }
std::string_view name_of(NightSide technique) { return technique == NightSide::none ? "none" : "lights"; }
std::string_view name_of(Rings technique) { return technique == Rings::none ? "none" : "plane"; }
std::string_view name_of(SunImage technique) { return technique == SunImage::none ? "none" : "disc"; }
std::string_view name_of(Stars technique) { return technique == Stars::none ? "none" : "noise"; }

double texel_angle(int texels) { return 2.0 / texels; }

namespace {

bool asks_for_real_size(const Scene& scene) {
  if (scene.terrain.model != model_auto) return scene.terrain.model > ground_icosphere;
  return scene.planet.radius >= real_radius && scene.terrain.height <= real_relief * scene.planet.radius;
}

}  // namespace

bool lacks_real_size(const Scene& scene) { return !has_real_size && asks_for_real_size(scene); }

Ground ground_technique(const Scene& scene) {
  if (scene.terrain.model == model_none) return Ground::none;
  if (!has_real_size || !asks_for_real_size(scene)) return Ground::icosphere;
  const int model = scene.terrain.model == model_auto ? ground_triangle_lod : scene.terrain.model;
  return static_cast<Ground>(model - ground_icosphere + static_cast<int>(Ground::icosphere));
}

int ground_level(const Scene& scene) {
  // From where the whole planet is seen; nearer, what the mesh can't carry comes from normals.
  const double altitude = std::max(scene.camera.altitude / scene.planet.radius, 0.5);
  const double pixel = altitude * 2.0 * std::tan(scene.camera.fov * 0.00872664626) / 720.0;
  const double allowed = scene.quality.pixel_error * pixel;
  const double height = scene.terrain.height / scene.planet.radius;
  const int finest = finest_relief_level(scene);
  for (int level = group_level; level < finest; ++level) {
    const double edge = icosphere_edge(level);
    const double missing = has_relief(scene) ? height * edge * scene.terrain.frequency : 0.0;
    if (edge * edge / 8.0 + missing < allowed) return level;
  }
  return finest;
}

double footprint_below(const Scene& scene, const Pose& pose) {
  return pose.pixel_angle * pose.nearest * footprint_of_pixel(scene);
}

bool may_move(const Scene& scene) {
  if (scene.time.speed == 0.0) return false;
  const bool waves = has_water(scene) && scene.waves.count > 0 && waves_run(scene);
  const bool ripples = has_water(scene) && has_ripples(scene) && scene.water.ripple_speed > 0.0;
  return clouds_move(scene) || waves || ripples;
}

Needs needs_of(const Scene& scene, const View& view, const Pose& pose) {
  Needs needs;
  Decisions decide(needs.decisions);
  decide_ground(needs, scene, pose, decide);
  decide_water(needs, scene, view, pose, decide);
  decide_clouds(needs, scene, pose, decide);
  decide_night(needs, scene, decide);
  decide_sun(needs, scene, view, pose, decide);
  decide_rings(needs, scene, decide);
  decide_rest(needs, scene, decide);
  needs.moving = anything_moves(needs, scene);
  return needs;
}

}  // namespace terrella
