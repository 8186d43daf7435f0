// The smoothest way from one height over level ground to another, over a distance: that of van Wijk and Nuij 2003,
// "Smooth and efficient zooming and panning". They ask what a viewer perceives as motion, how fast things move through
// the picture and how fast they grow, and find the way with the least of it: it rises, moves on and comes down again.
#pragma once

namespace terrella {

class Glide {
 public:
  // Where one is on the way: how far over the ground and how high over it, in one unit of length.
  struct Point {
    double along, height;
  };

  // Their rho, how readily it rises; what people like is about 1.4. In a unit of length() the place moves by at most
  // height / curvature, and the height's logarithm by at most curvature.
  static constexpr double curvature = 1.4;

  // distance >= 0, heights > 0; none beyond 1e60, heights not below 1e-60.
  Glide(double distance, double from_height, double to_height);

  // What is perceived of the way as a whole; about as many seconds as one likes to look at it.
  [[nodiscard]] double length() const { return angle_ / curvature; }

  // The way at a part of its length: 0..1, but it goes on beyond both ends. along: from its beginning, or from its end,
  // before which it is negative. Each is as exact near its own end as anywhere.
  [[nodiscard]] Point from_start(double part) const { return walk(there_, angle_ * part); }
  [[nodiscard]] Point from_end(double part) const;

 private:
  // With distances multiplied by curvature^2, the way is part of a circle around a point at height 0: a straight line
  // of hyperbolic geometry, in which each unit of `angle` is a step of the same length.
  struct Arc {
    double height;    // where it begins
    double level;     // cosine of the climb with which it begins, 0..1
    double up, down;  // 1 and 0 where it rises straight up, 0 and 1 where it falls; exact where they are small
  };
  static Arc arc(double distance, double from_height, double to_height);
  static Point walk(const Arc& arc, double angle);

  Arc there_, back_;  // the same circle from both ends
  double angle_;      // of the whole way
};

}  // namespace terrella
