// How still pictures hold: under a camera that hardly moves, as time runs, and when the whole scene is scaled or
// turned.
#pragma once

#include "measure/checks.hpp"
#include "render/renderer.hpp"

namespace terrella {

// By how much what is seen moved on the screen while the camera moved by a thousandth of a pixel.
struct Jitter {
  double largest = 0.0;     // pixels, over all that could be measured; a thousandth where nothing jitters
  double nearly_all = 0.0;  // pixels, that 99 of a hundred stay below: the rest may lie at edges of hills
  double measured = 0.0;    // part of the pixels of the planet that could be measured
  std::int64_t planet = 0;  // pixels of the planet
};

// Pixels of the planet whose value moved, told from two pictures of a channel and how steep it is from pixel to pixel
// there: floats of the same view before and after, as for Pixels. Left out are pixels at edges (where the channel
// jumps) and those where it is so level that its own rounding, a few times 2^-24 of the value, hides a hundredth of a
// pixel. allowance: by how much the channel may change without anything moving across the screen.
Jitter jitter_between(Pixels before, Pixels after, int width, int height, int channels, double allowance);

// Of the distances, where the surface itself is seen to move, or of the normals, where what it carries is: ripples and
// waves. The camera is moved along the surface by as much as the nearest ground needs to move by a thousandth of a
// pixel.
Jitter jitter_of(Renderer& renderer, const Scene& scene, const View& view, Channel channel);

// How a picture changes over three frames, a sixtieth of a second apart. The fiftieth of its pixels that change least
// evenly is left out: crests that hide what is behind them and sparkles come and go from one frame to the next.
struct Motion {
  double change = 0.0;  // from frame to frame: root of the mean square, of light L as L / (1 + L)
  double unrest = 0.0;  // change of the change, as a part of it: near 0 where it runs evenly, 1.7 for noise
};
Motion motion_between(Pixels first, Pixels second, Pixels third);
// Of Channel::color, or of the normals, which show the waves alone.
Motion motion_at(Renderer& renderer, const Scene& scene, View view, double seconds, Channel channel);

// Peak signal to noise of b against a, dB; the peak is 1. Infinite where they are alike.
double light_psnr(Pixels a, Pixels b);

}  // namespace terrella
