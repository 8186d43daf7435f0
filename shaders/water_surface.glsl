// The surface of the water: what its ways of finding normals have in common.
#include "ground_map.glsl"
#include "water_look.glsl"
#include "output.glsl"

in vec3 surface_from_eye;

// How deep the water is (radii; below 0 where land stands out of it) in the direction of the place. Asked for first, and once.
float depth_below(vec3 up);

// What comes from under the surface. ray: unit, in the water, down.
vec3 light_from_below(Water w, LightAt at, vec3 ray, float shade, SceneLight scene);

// Whether a ray from the eye begins in the water.
bool begins_in_water(vec3 ray);

// Light of the surface as it comes to the eye, from whichever side that sees it. ray: unit, from the eye.
vec3 surface_to_eye(Water w, LightAt at, vec3 ray, float shade, SceneLight scene);

// Its side that the eye sees. up: unit.
vec3 side_of_eye(vec3 up) { return begins_in_water(surface_from_eye) ? -up : up; }

// The shore belongs to the map of the ground, which is finer than either mesh: where it says land, the water's mesh shows
// land. There nothing is refracted and nothing mirrored, which costs less than a second way of shading would. up: unit, of
// the still water; height: over it, radii.
void emit_water(Water w, vec3 up, float height) {
  SceneLight scene = scene_light();
  LightAt at = light_at(up, 0.0, scene);
  vec3 ray = normalize(surface_from_eye);
  float shade = shade_of_clouds(up * sea.x);
  emit_surface(surface_to_eye(w, at, ray, shade, scene), surface_from_eye, w.normal, sea.x - 1.0 + height);
}
