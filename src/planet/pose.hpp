// Where a picture is taken from, worked out in double precision. Lengths in planet radii; the planet's centre is the
// origin, its axis is z, latitude and longitude 0 lie on x.
#pragma once

#include <array>
#include <optional>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.hpp"

namespace terrella {

// A picture that is drawn in several parts, around the middle of which the camera looks.
struct WholePicture {
  int width, height;  // pixels, >= 1
  double field;       // as of View
};

// What a picture depends on beside the scene.
struct View {
  int width = 1280;       // pixels, >= 1
  int height = 720;       // pixels, >= 1
  double seconds = 0.0;   // since the scene began
  double scale = 1.0;     // pixels along a side for each one that is shown
  glm::dvec2 shift{0.0};  // of all that is seen, in pixels right and down: for samples and tiles, or past a panel
  double field = 1.0;     // tangent of half the angle that the height covers, as a multiple of that of half camera.fov:
                          // less for tiles of a larger picture, more for upright windows
  std::optional<WholePicture> whole = std::nullopt;  // that it is a tile or a sample of, if any
};

// The view of the whole picture that one is a part of; itself, if of none.
View whole_of(const View& view);

// A view of the pixels that are shown as one of those that are drawn. scale: so many along a side for each shown, > 0;
// less where there would be more than `most` along one.
View drawn_at(View shown, double scale, int most);

struct Pose {
  glm::dvec3 eye;
  glm::dvec3 forward, right, up;  // unit
  double tan_half_fov;            // of the picture's vertical field of view
  double pixel_angle;             // rad, in the middle of the picture
  double clearance;               // height of the eye over the surface that it is kept above (surface_radius)
  double over_water;              // height of the lens over the water that may pass over it; infinite where none may
  glm::dvec3 water_normal;        // unit, of that water
  double nearest;                 // distance of the nearest of what lies above and below the eye
  double near, far;               // distances between which everything lies
  bool raised;                    // the asked place was under the ground or the sea, short waves apart
};

// The camera comes no nearer to the ground, radii: on a miniature planet as an ant walks, on a large one as a child.
double least_clearance(const Scene& scene);

// Unit vector to a place on the planet. Degrees.
glm::dvec3 direction_of(double latitude, double longitude);

// Radius of the surface that a camera is kept above at a direction, as seen and as computed in full: of the ground, and
// of the sea if that is higher and the camera doesn't dive: under waves that are long beside the planet, of the highest
// crest that may come there; of a sea of short ones, as it is without them.
double surface_radius(const Scene& scene, const glm::dvec3& direction);

// Total: any scene that passes validation gives a finite pose.
Pose pose_of(const Scene& scene, const View& view);
// The same for as long as the icosphere's coarse mesh (coarse_level) is drawn, which hills of the fine one lie under.
Pose pose_over_coarse_ground(const Scene& scene, const View& view);

// The unit direction that a pixel (from the top left, may be fractional) looks along.
glm::dvec3 ray_through(const Pose& pose, const View& view, const glm::dvec2& pixel);

// A part of a picture, each side 0..1 of its width or height, from the bottom left.
struct PictureBox {
  double left = 0.0, bottom = 0.0, right = 1.0, top = 1.0;
};

// Rows [first, end) of a picture's pixels, counted from the bottom.
struct Rows {
  int first = 0, end = 0;

  bool operator==(const Rows&) const = default;
};

// The unit normal of a plane through the eye: what the picture shows on the side that it points to begins in the air,
// the rest in the water. It cuts the near plane, where the lens is, as the surface of the water does in its middle.
glm::dvec3 lens_above_water(const Pose& pose);

// Whether the lens, or a part of it, is under water.
bool is_in_water(const Pose& pose, const View& view);
bool is_all_in_water(const Pose& pose, const View& view);

// Two unit vectors that point inwards from the planes through the eye between which rows lie, with a margin (rad)
// around them; zero on a side where the rows reach the picture's edge.
std::array<glm::dvec3, 2> sides_of(const Pose& pose, const View& view, const Rows& rows, double margin);

// Half the angle of the cone around pose.forward that holds the whole picture, rad.
double picture_half_angle(const Pose& pose, const View& view);

// What a sphere around the planet's centre can cover. radius: planet radii; around the eye, all of the picture.
PictureBox box_of_sphere(const Pose& pose, const View& view, double radius);

// As high as ground can rise, radii; 1 where there is none.
double ground_top(const Scene& scene);

// As high as ice on the sea can rise, radii; 1 where there is none.
double ice_top(const Scene& scene);

// The highest that ground, ice and sea rise, radii.
double relief_top(const Scene& scene);

// The same of clouds as well.
double top_radius(const Scene& scene);

// Radius that nothing of a scene but the stars lies beyond.
double outermost_radius(const Scene& scene);

// How far (planet radii) a surface may be moved towards or away from the planet's centre so that no part of it that is
// seen is moved by more than a pixel. Seen from d radii from the centre of a sphere, a radial change shows most at an
// angle whose cosine is 2 d / (1 + d^2), as its length times d / (d^2 - 1).
double pixel_of_height(const Pose& pose);
// The same of the surface of the water, which may pass over the eye.
double pixel_of_water_height(const Pose& pose);

// How distances along the middle of the picture become depths, which fall with them: clip z is scale * w + offset *
// near.
struct DepthScheme {
  double scale, offset;
  double far_plane;   // clip z at infinity, as a part of w
  double log_factor;  // above 0: clip z is w * (1 - log_factor * log2(w / near)) instead
};

// from_zero: whether the driver stores depths of 0 to 1 as they are, not mapped from -1..1, which takes from floats
// what they tell apart far away. Where they are, and distances differ too much for what is left, they go by logarithms.
DepthScheme depth_scheme(const Pose& pose, bool from_zero);

// From positions relative to the eye to clip space.
glm::mat4 clip_from_eye(const Pose& pose, const View& view, const DepthScheme& depths);

}  // namespace terrella
