// The shell of clouds where its map is as fine as the pixels.
#include "cloud_surface.glsl"

void main() {
  vec3 up = normalize(eye_position() + surface_from_eye);
  float noise = cloud_noise(up);
  float climb = dot(up, sun_direction.xyz);
  vec3 toward = sun_direction.xyz - climb * up;
  emit_clouds(up, noise, noise_rise(up, toward, cloud_reach(climb), noise));
}
