// Lights on the ground, lit where the sun has gone.
#include "light_block.glsl"
#include "lib/stars.glsl"
#include "square_corner.glsl"

layout(location = 0) in vec4 light;  // xyz: position, planet radii; w: brightness, 0..1

uniform vec2 picture_size;  // pixels

out vec3 square_light;
out vec2 square_place;  // in radii of the light

void main() {
  vec3 offset = from_eye(light.xyz);
  float pixel_angle = fineness.z * ray_forward.w;
  TownLight town =
      town_light(light.xyz, offset, light.w, lights_color.rgb, lights_brightness, pixel_angle, scene_light());
  square_light = fineness.w * town.light;
  vec2 corner = square_corner();
  square_place = 2.0 * corner;
  // Nearer along the ray by its own size, so that the ground it stands on does not cut it.
  gl_Position = clip_at(offset * max(1.0 - 0.004 / length(offset), 0.5));
  gl_Position.xy += corner * 4.0 * fineness.z * town.radius / picture_size * gl_Position.w;
}
