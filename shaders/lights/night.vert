// Lights on the ground, lit where the sun has gone.
#include "scene_block.glsl"
#include "frame_block.glsl"
#include "lib/night.glsl"
#include "square_corner.glsl"

layout(location = 0) in vec4 light;  // xyz: position, planet radii; w: brightness, 0..1

uniform vec2 picture_size;  // pixels

out vec3 square_light;
out vec2 square_place;  // in radii of the light

void main() {
  vec3 offset = from_eye(light.xyz);
  vec3 up = normalize(light.xyz);
  float away = length(offset);
  float night = night_share(dot(up, sun_direction.xyz));
  float facing = clamp(-2.5 * dot(up, offset) / away, 0.0, 1.0);
  // As wide as a town; never smaller than a pixel, but dimmer.
  float wide = 0.0015 / (away * ray_forward.w);
  float radius = max(wide, 0.9);
  float share = min(wide / radius, 1.0);
  square_light = lights_color.rgb * (4.0 * lights_brightness * light.w * night * facing * share * share);
  vec2 corner = square_corner();
  square_place = 2.0 * corner;
  // Nearer along the ray by its own size, so that the ground it stands on does not cut it.
  gl_Position = clip_from_eye * vec4(offset * max(1.0 - 0.004 / away, 0.5), 1.0);
  gl_Position.xy += corner * 4.0 * radius / picture_size * gl_Position.w;
}
