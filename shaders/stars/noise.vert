// Stars as small squares at infinity: points are drawn a little differently by each kind of OpenGL.
#include "light_block.glsl"
#include "lib/stars.glsl"
#include "square_corner.glsl"

layout(location = 0) in vec4 star;   // xyz: direction; w: brightness
layout(location = 1) in vec3 color;

uniform vec2 picture_size;  // pixels

out vec3 square_light;
out vec2 square_place;  // in radii of the star

void main() {
  // A dim star is not smaller than a pixel, but dimmer: it does not twinkle as it moves over the pixels.
  square_light = fineness.w * star_light(color.rgb, star.w, stars_brightness) * sky_shown(star.xyz, scene_light());
  vec2 corner = square_corner();
  square_place = 2.0 * corner;
  gl_Position = clip_along(star.xyz);
  gl_Position.xy += corner * 4.0 * fineness.z * star_radius(stars_size, star.w) / picture_size * gl_Position.w;
}
