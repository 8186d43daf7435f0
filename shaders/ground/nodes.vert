#include "node_vertex.glsl"

out vec3 surface_from_eye;

void main() {
  NodeVertex v = node_vertex();
  surface_from_eye = node_centre.xyz + v.place;
  surface_from_eye += length(surface_from_eye) * v.skirt;
  gl_Position = clip_at(surface_from_eye);
}
