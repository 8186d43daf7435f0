// What water shows behind all that is in it.
#include "eye_in_water.glsl"
#include "output.glsl"

in vec3 view_ray;

void main() {
  if (!begins_in_water(view_ray)) discard;
  const float far = 1.0e3;  // radii
  SceneLight scene = scene_light();
  vec3 up = normalize(eye_position()), ray = normalize(view_ray);
  float climb = dot(up, ray);
  vec3 light;
  if (climb <= 0.0) {
    light = to_eye_in_water(vec3(0.0), far * ray, scene);
  } else {
    // As far as to the surface, which throws back what comes from below.
    LightAt at = light_at(up, 0.0, scene);
    float shade = shade_of_clouds(sea.x * up);
    vec3 mirrored = through_water(vec3(0.0), 0.0, -climb, far, at, shade, water_look(), scene);
    light = through_water(mirrored, lens.w, climb, min(lens.w / climb, far), at, shade, water_look(), scene);
  }
  emit_surface(light, view_ray, vec3(0.0), 0.0);
}
