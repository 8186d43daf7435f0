// Stars as small squares at infinity: points are drawn a little differently by each kind of OpenGL.
#include "scene_block.glsl"
#include "frame_block.glsl"
#include "lib/air.glsl"
#include "square_corner.glsl"

layout(location = 0) in vec4 star;   // xyz: direction; w: brightness
layout(location = 1) in vec4 color;  // w: radius of a glow, rad; 0: a star

uniform vec2 picture_size;  // pixels

out vec3 square_light;
out vec2 square_place;  // in radii of the star

void main() {
  vec4 place = clip_from_eye * vec4(star.xyz, 0.0);
  // A dim star is not smaller than a pixel, but dimmer: it does not twinkle as it moves over the pixels.
  bool glow = color.w > 0.0;
  float star_radius = glow ? color.w / ray_forward.w : stars_size * (0.8 + 0.8 * star.w);
  square_light = color.rgb * stars_brightness * (glow ? star.w : 0.10 + 2.2 * star.w);
  if (ripple.z > 0.0) {
    // Hidden by the planet's air; seen from within, by the daylight.
    float top = 1.0 + air_height;
    AirPath path = air_path(eye_position(), star.xyz, top);
    vec3 up = normalize(eye_position());
    float inside = 1.0 - smoothstep(0.9 * air_height, air_height, eye_high.w);
    float from_within = exp(-6.0 * air_density * smoothstep(-0.25, 0.1, dot(up, sun_direction.xyz))) *
                        smoothstep(0.0, 0.3, dot(up, star.xyz));
    square_light *= mix(path.leave > path.enter ? 0.0 : 1.0, from_within, inside);
  }
  vec2 corner = square_corner();
  float reach = glow ? 1.35 : 2.0;  // in radii: of a glow, up to where nothing is left to see
  square_place = reach * corner;
  place.xy += corner * 2.0 * reach * star_radius / picture_size * place.w;
  gl_Position = vec4(place.xy, place.w, place.w);  // at the far plane
}
