// The rings of the scene.
#include "light_block.glsl"
#include "output.glsl"
#include "lib/rings.glsl"

Rings scene_rings() {
  Rings r;
  r.inner = rings_inner;
  r.outer = rings_outer;
  r.density = rings_density;
  r.color = rings_color.rgb;
  r.seed = uint(rings_seed);
  return r;
}
