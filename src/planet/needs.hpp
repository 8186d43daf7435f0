// What a scene and a view require, and why: the only place that decides what is modelled and how finely.
#pragma once

#include <string>
#include <vector>

#include "planet/pose.hpp"
#include "scene/scene.hpp"

namespace terrella {

enum class Ground { none, icosphere, persistent_grid, triangle_lod, quadtree };
enum class Water { none, calm, waves };
enum class Clouds { none, shell };
enum class Air { none, fresnel };
enum class Stars { none, noise };
enum class NightSide { none, lights };
enum class SunImage { none, disc };
enum class Rings { none, plane };

std::string_view name_of(Ground technique);
std::string_view name_of(Water technique);
std::string_view name_of(Clouds technique);
std::string_view name_of(Air technique);
std::string_view name_of(Stars technique);
std::string_view name_of(NightSide technique);
std::string_view name_of(SunImage technique);
std::string_view name_of(Rings technique);

struct Decision {
  std::string what;    // "clouds.octaves"
  std::string chosen;  // "4"
  std::string why;     // a sentence
};

struct Needs {
  Ground ground = Ground::none;
  Water water = Water::none;
  Clouds clouds = Clouds::none;
  Air air = Air::none;
  Stars stars = Stars::none;
  NightSide night = NightSide::none;
  SunImage sun = SunImage::none;
  Rings rings = Rings::none;

  int ground_level = 0;         // icosphere level of the finished ground
  double ground_spacing = 0;    // of the vertices of its mesh, of nodes below the eye, rad
  bool ground_mapped = false;   // a map of heights tells the continents
  double ground_tolerance = 0;  // by how much its triangles may miss its vertices, radii
  int ground_texels = 0;        // side of a face of its map
  double ground_split = 0;      // of a ground of nodes: nearer than so many of its edges a node is split
  double ground_finest = 0;     // their vertices need not be closer than this, rad
  int ground_cells = 0;         // along a side of each
  int pixel_octaves_first = 0;  // octaves of the ground computed at every pixel, because the map can't show them:
  int pixel_octaves_end = 0;    // [first, end); equal: none
  int water_level = 0;          // icosphere level of the sea
  double water_lift = 0;  // by how much its mesh is raised, radii, or of nodes parts of the distance; never more than
                          // may be seen
  double water_most_lift = 0;  // of the sea of nodes, radii
  bool hides_waves = false;    // the sea of nodes has waves that are too small to be seen
  double water_hides = 0;      // depth from which nothing is seen of the ground, radii
  bool in_water = false;       // the lens, or a part of it, is under water
  double water_sight = 0;      // how far one sees where all of it is, radii; 0: it is not
  double mirrored_land = 0;    // how much the water shows of land that stands in its mirror, 0..1
  double sea_swell = 0;        // by how much waves raise and move the sea of nodes at the most, radii
  int ripple_layers = 0;       // of small waves as flow noise at every pixel of a calm sea, and of its crust
  int cloud_level = 0;         // icosphere level of the shell of clouds
  int cloud_octaves = 0;       // that the map of the clouds holds, the finest maybe in part
  int cloud_pixel_first = 0;   // octaves of the clouds computed at every pixel, because the map can't show them whole:
  int cloud_pixel_end = 0;     // [first, end); equal: none
  int cloud_texels = 0;
  double cloud_interval = 0.0;  // s between two pictures of the clouds, blended in between; 0: they do not change
  bool moving = false;          // something changes with time

  std::vector<Decision> decisions;
};

// The ground while a parameter is dragged: this icosphere level and this map, whatever the scene.
inline constexpr int coarse_level = 5;
inline constexpr int coarse_ground_texels = 96;
inline constexpr int coarse_cloud_texels = 96;

// By how much the coarsest layer of clouds turns between two pictures of them, at most, rad.
inline constexpr double longest_blend_turn = 1.0;

// Whether pixels add layers that the map of the ground can't hold.
inline bool refines_ground(const Needs& needs) { return needs.pixel_octaves_end > needs.pixel_octaves_first; }

// How far apart samples are, in pixels, for whoever asks what they can show: what is smaller than two of that is left
// out.
inline double footprint_of_pixel(const Scene& scene) { return 0.5 * scene.quality.finest_layer; }

// The same of what lies nearest below the eye, rad.
double footprint_below(const Scene& scene, const Pose& pose);

// Distance of neighbouring texels in the middle of a cube map's face, rad.
double texel_angle(int texels);

// Whether it is drawn as nodes that are split where they are near.
constexpr bool has_nodes(Ground technique) { return technique >= Ground::persistent_grid; }

// Whether a scene is to have a ground of nodes, which this program does not draw (has_real_size).
bool lacks_real_size(const Scene& scene);

// How the ground is drawn, which depends on nothing but the scene.
Ground ground_technique(const Scene& scene);

// The icosphere level that the ground settles on.
int ground_level(const Scene& scene);

// Whether a picture of the scene can change with time, however finely it is drawn.
bool may_move(const Scene& scene);

Needs needs_of(const Scene& scene, const View& view, const Pose& pose);

}  // namespace terrella
