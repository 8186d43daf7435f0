// A flight from one view to another: along a great circle over the ground, as high as one likes to look at it
// (glide.hpp).
#pragma once

#include <glm/vec2.hpp>

#include "planet/facing.hpp"
#include "planet/glide.hpp"
#include "scene/scene.hpp"

namespace terrella {

// Where a camera is, told from a place and a facing there. Lengths in planet radii.
struct Step {
  glm::dvec2 way{0.0};     // over the ground, rad to the right and ahead, along one great circle
  double turn = 0.0;       // to the right, rad, of what faced ahead and was carried along
  double ground = 1.0;     // radius from which the clearance counts: what lies below, without what is small beside it
  double clearance = 1.0;  // > 0
  double pitch = 0.0;      // degrees
  double fov = 45.0;       // degrees
  double roll = 0.0;       // degrees
};

// A step between two others; share: 0 gives `from`, 1 gives `to`.
Step between(const Step& from, const Step& to, double share);

class Flight {
 public:
  // Total: from any view to any other, also the same one, or the antipode (over a pole). Looks at the ground at both
  // ends.
  Flight(const Scene& scene, const Camera& from, const Camera& to);

  // Views at its ends, with altitudes that ground and sea allow.
  [[nodiscard]] const Camera& from() const { return from_.camera; }
  [[nodiscard]] const Camera& to() const { return to_.camera; }

  // What is perceived of it, in about as many seconds as one likes to look at it: at most as fast as a Glide is, in the
  // mean no faster than 45 degrees or a doubling of what is magnified a unit. 0: it changes nothing.
  [[nodiscard]] double length() const { return length_; }

  // Whether place or height change by more than rounding does; else it turns at most.
  [[nodiscard]] bool moves() const { return glide_.length() > 1e-9; }

  // The view at a part of it, 0..1: equal steps are perceived as equally fast. Exactly from() and to() at the ends. The
  // clearance over the ground is that of a Glide, so straight down it falls by the same factor for equal steps; turns
  // begin and end gently, the short way (half a turn: either). Where it rises, it looks down as far as the planet needs
  // to stay in the picture. Where hills would be in the way, it is for pose_of to rise above them.
  [[nodiscard]] Camera at(double part) const;

  // The same, told from what faces ahead at one of the ends. It goes on beyond both of them, where nothing turns.
  [[nodiscard]] Step from_start(double part) const;
  [[nodiscard]] Step from_end(double part) const;

 private:
  struct End {
    Camera camera;
    Facing facing;
    double ground, clearance;  // radii
    double bearing = 0.0;      // of the great circle, rad to the right of ahead
    double residual = 0.0;     // what the ground there rises over smooth_ground
  };
  static End end_of(const Scene& scene, const Camera& camera);
  void lay_great_circle();
  [[nodiscard]] double smooth_ground(double part) const;
  [[nodiscard]] double tilt(double clearance, double part) const;
  [[nodiscard]] Step step(double part) const;

  Scene scene_;
  End from_, to_;
  double angle_ = 0.0;  // over the ground, rad, 0..pi
  double turn_ = 0.0;   // rad to the right
  Glide glide_;
  double length_;
};

// The camera a step away from a facing, its altitude within what a scene allows. radius: of the planet, m.
Camera camera_at(const Facing& facing, const Step& step, double radius);

}  // namespace terrella
