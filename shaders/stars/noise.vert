// Stars as points at infinity.
#include "scene_block.glsl"
#include "frame_block.glsl"
#include "lib/air.glsl"

layout(location = 0) in vec4 star;   // xyz: direction; w: brightness
layout(location = 1) in vec4 color;

out vec3 star_light;
out float star_radius;  // pixels

void main() {
  vec4 place = clip_from_eye * vec4(star.xyz, 0.0);
  // A dim star is not smaller than a pixel, but dimmer: it does not twinkle as it moves over the pixels.
  star_radius = stars_size * (0.75 + 0.75 * star.w);
  star_light = color.rgb * stars_brightness * (0.10 + 2.2 * star.w);
  if (ripple.z > 0.0) {
    // Hidden by the planet's air; seen from within, by the daylight.
    float top = 1.0 + air_height;
    AirPath path = air_path(eye_position(), star.xyz, top);
    vec3 up = normalize(eye_position());
    float inside = 1.0 - smoothstep(0.9 * air_height, air_height, eye_high.w);
    float from_within = exp(-6.0 * air_density * smoothstep(-0.25, 0.1, dot(up, sun_direction.xyz))) *
                        smoothstep(0.0, 0.3, dot(up, star.xyz));
    star_light *= mix(path.leave > path.enter ? 0.0 : 1.0, from_within, inside);
  }
  gl_PointSize = 2.0 * star_radius + 2.0;
  gl_Position = vec4(place.xy, place.w, place.w);  // at the far plane
}
