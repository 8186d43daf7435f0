// The part of the sky that has air before it: a ring around the planet seen from outside, the whole picture from within.
#include "frame_block.glsl"
#include "lib/tangent.glsl"

uniform vec4 ring;  // x, y: tangents of the angles at which it begins and ends; z: number of its corners, 0: the whole picture

out vec3 view_ray;

void main() {
  float side = float(gl_VertexID & 1);
  float step = float(gl_VertexID >> 1);
  if (ring.z > 0.0) {
    vec3 axis = -normalize(eye_position());
    vec3 u = perpendicular(axis);
    vec3 v = cross(axis, u);
    float turn = 6.283185307179586 * step / ring.z;
    view_ray = axis + mix(ring.x, ring.y, side) * (cos(turn) * u + sin(turn) * v);
    gl_Position = clip_along(view_ray);
  } else {
    vec2 corner = 2.0 * vec2(side, step) - 1.0;
    view_ray = ray_forward.xyz + corner.x * ray_right.xyz + corner.y * ray_up.xyz;
    gl_Position = vec4(corner, depth.x, 1.0);
  }
}
