// The clouds of the scene, whose noise a map holds.
#include "light_block.glsl"
#include "lib/cloud_light.glsl"

// The noise that clouds are made from, at three moments; cloud_moments weights them.
uniform samplerCube clouds_map;

Clouds scene_clouds() {
  Clouds c;
  c.height = clouds_height;
  c.thickness = clouds_thickness;
  c.coverage = clouds_coverage;
  c.softness = clouds_softness;
  c.density = clouds_density;
  c.shadow = clouds_shadow;
  c.color = clouds_color.rgb;
  return c;
}

// The noise that clouds are made from, at the frame's time.
float cloud_noise(vec3 direction) {
  // Texels of 10 bits are cheaper to fetch than floats where there is no graphics card.
  return noise_from_map(dot(textureLod(clouds_map, drifted(direction, cloud_turn.xy), cloud_turn.z).rgb, cloud_moments.xyz));
}

// Part of the sunlight that the clouds leave at a place.
float shade_of_clouds(vec3 place) {
  if (cloud_turn.w == 0.0 || clouds_shadow == 0.0) return 1.0;
  Clouds clouds = scene_clouds();
  float noise = cloud_noise(cloud_before_sun(place, sun_direction.xyz, clouds));
  return cloud_shade(place, cloud_thickness(noise, clouds_coverage, clouds_softness), clouds);
}
