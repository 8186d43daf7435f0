// What water shows behind all that is in it.
#include "water_look.glsl"
#include "output.glsl"

in vec3 view_ray;

void main() {
  if (!begins_in_water(view_ray)) discard;
  const float far = 1.0e3;  // radii
  vec3 up = normalize(eye_position()), ray = normalize(view_ray);
  // The surface throws it back.
  ray -= 2.0 * max(dot(ray, up), 0.0) * up;
  emit_surface(to_eye_in_water(vec3(0.0), far * ray, scene_light()), view_ray, vec3(0.0), 0.0);
}
