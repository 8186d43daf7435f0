// The corner of a square (gl::Squares) that this vertex is, -1 or 1 along each side: of two triangles, 0 1 2 and 1 3 2.
vec2 square_corner() {
  int corner_of = gl_VertexID % 6;
  int c = corner_of < 3 ? corner_of : corner_of == 3 ? 1 : corner_of == 4 ? 3 : 2;
  return vec2(float(c & 1), float(c >> 1)) * 2.0 - 1.0;
}
