// All that the passes are told about a frame.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "planet/icosphere_groups.hpp"
#include "planet/mirror.hpp"
#include "planet/needs.hpp"
#include "planet/pose.hpp"
#include "planet/waves.hpp"
#include "scene/scene.hpp"

namespace terrella {

// What a picture shows; all but color are measurements, drawn without blending.
enum class Channel : int { color = 0, distance = 1, normal = 2, height = 3 };

// How much a frame may leave for later ones.
enum class Effort {
  soonest,   // the first picture of all: nothing but the air, where there is any
  hurried,   // a parameter is being dragged: coarse, and nothing finer is begun
  live,      // coarse until finer maps, made over several frames, are ready
  complete,  // everything is made at once, however long it takes
};

// For what the CPU makes for a frame that may leave some of it for later ones: so little that no one waits for it where
// frames come quickly.
inline constexpr double least_making_ms = 5.0;

// Which ground is drawn, where one way of dividing it gives way to the next.
enum class GroundShown { now, before };

// As in shaders/frame_block.glsl, std140.
struct FrameBlock {
  glm::mat4 clip_from_eye;
  glm::vec4 eye_high, eye_low;
  glm::vec4 ray_forward, ray_right, ray_up;
  glm::vec4 sun_direction, sun_light;
  glm::vec4 ground_map_scale;
  glm::vec4 cloud_turn;
  glm::vec4 cloud_moments;
  glm::vec4 sea;
  glm::vec4 ripple, ripple_turn;
  glm::vec4 water_extinction;
  glm::vec4 water_depths;
  glm::vec4 levels;
  glm::vec4 slopes;
  glm::vec4 sky_glow;
  glm::vec4 fineness;
  glm::vec4 depth;
  glm::vec4 lens;
  glm::mat4 mirror_from_eye;
  glm::vec4 mirror;
  glm::ivec4 channel;
};

struct Frame {
  const Scene& scene;
  const View& view;
  const Pose& pose;
  const Needs& needs;
  const Sea& sea;
  Channel channel = Channel::color;
  Effort effort = Effort::complete;
  Rows rows;                           // of the picture that are drawn now; all else of it is as for the whole
  double making_ms = least_making_ms;  // for what the CPU makes, unless all is to be complete
  const Pose* levels_for = nullptr;    // for which levels of detail of nodes are chosen; none: its own
  GroundShown ground_shown = GroundShown::now;
  const Mirror* mirror = nullptr;  // in which land stands, if in any
  bool is_mirror = false;          // it is the picture of that land
};

// Whether its rows are all that the picture has.
inline bool draws_all(const Frame& frame) { return frame.rows == Rows{0, frame.view.height}; }

// Around what is drawn of some rows (rad): room for squares, which are wider than their place.
double margin_of_rows(const Frame& frame);

Sight sight_of(const Frame& frame);

// Radius of a sphere that ground or water hides whole, whatever their flat triangles dip below it; 0 if there is
// neither.
double solid_radius(const Needs& needs);

// Between which radii the water is drawn, troughs and the dips of flat triangles included; 0 and 0 where there is none.
RadiusRange water_range(const Frame& frame);

// The lowest that the water's flat triangles would lie without waves, planet radii; 0 where there is none.
double lowest_still_water(const Frame& frame);

// The maps that passes read, as they are for a frame.
struct Maps {
  double ground_texel = texel_angle(1);  // distance of the texels of the map of the ground, rad
  double ground_level = 0.0;             // of its mipmap that pixels can show
  double cloud_level = 0.0;
  glm::dvec3 cloud_moments{0.0};  // weights of the moments that the map of the clouds holds
};

// The level of a mipmap at which its texels (rad apart at level 0) are as far apart as pixels on a sphere of a radius.
double map_level(const Frame& frame, double radius, double texel);

FrameBlock frame_block(const Frame& frame, const Maps& maps);

}  // namespace terrella
