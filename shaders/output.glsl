// What every pass that draws into the picture gives: light, or one of the measurements.
#include "frame_block.glsl"

out vec4 fragment;

// Light of an opaque surface, or a measurement of it. from_eye, height: radii; normal: unit, planet axes.
void emit_surface(vec3 light, vec3 offset_from_eye, vec3 normal, float height) {
  if (channel.x == 0) fragment = vec4(light * sun_direction.w, 1.0);
  else if (channel.x == 1) fragment = vec4(vec3(length(offset_from_eye)), 1.0);
  else if (channel.x == 2) fragment = vec4(normal, 1.0);
  else fragment = vec4(vec3(height), 1.0);
}

// Light in front of what is drawn already, which shines through by 1 - opacity. light: already weighted by opacity.
void emit_veil(vec3 light, float opacity) {
  fragment = vec4(light * sun_direction.w, opacity);
}
