// The shell of clouds, lit by the sun through itself, seen from above and from below: what its ways of finding the noise
// have in common.
#include "cloud_map.glsl"
#include "output.glsl"

in vec3 surface_from_eye;

// As far as the map tells.
CloudAt cloud_of_map() {
  CloudAt at = cloud_place(normalize(eye_position() + surface_from_eye), sun_direction.xyz, scene_clouds());
  at.noise = cloud_noise(at.up);
  at.rise = cloud_noise(cloud_entry(at)) - at.noise;
  return at;
}

void emit_clouds(CloudAt cloud) {
  if (cloud_thickness(cloud.noise, clouds_coverage, clouds_softness) <= 0.0) discard;
  Veil veil = cloud_veil(cloud, surface_from_eye, scene_clouds(), scene_light());
  emit_veil(veil.light, veil.opacity);
}
