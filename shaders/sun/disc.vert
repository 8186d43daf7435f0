// A square around the sun, at infinity, so large that no perspective makes a circle reach beyond it.
#include "scene_block.glsl"
#include "frame_block.glsl"

uniform float reach;  // tangent of the angle around the sun's middle that is drawn

out vec3 sun_ray;  // from the eye, of any length

void main() {
  vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
  vec4 place = clip_along(sun_direction.xyz);
  // Away from the picture's middle a circle grows to an ellipse: most outwards, to where the angles' sum has its tangent.
  float aside = length(vec2(place.x * length(ray_right.xyz), place.y * length(ray_up.xyz))) / max(place.w, 1.0e-3);
  float extent = (aside + reach) / max(1.0 - aside * reach, 0.02) - aside;
  sun_ray = sun_direction.xyz + extent * place.w * (corner.x * normalize(ray_right.xyz) + corner.y * normalize(ray_up.xyz));
  gl_Position = place;
  gl_Position.xy += corner * extent * place.w / vec2(length(ray_right.xyz), length(ray_up.xyz));
}
