// Cube maps as OpenGL numbers their faces.

// The direction, not of unit length, of a place on a face: +x, -x, +y, -y, +z, -z; place: -1..1 each way.
vec3 cube_face_direction(int face, vec2 place) {
  if (face == 0) return vec3(1.0, -place.y, -place.x);
  if (face == 1) return vec3(-1.0, -place.y, place.x);
  if (face == 2) return vec3(place.x, 1.0, place.y);
  if (face == 3) return vec3(place.x, -1.0, -place.y);
  if (face == 4) return vec3(place.x, -place.y, 1.0);
  return vec3(-place.x, -place.y, -1.0);
}
