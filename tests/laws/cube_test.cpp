#include <gtest/gtest.h>

#include "formulas/formulas.hpp"
#include "laws/random_places.hpp"

namespace terrella {
namespace {

struct Face {
  int face;
  glm::dvec2 place;
};

// The other way round, by the table of the OpenGL specification (section 8.13, "Cube Map Texture Selection").
Face face_of(const glm::dvec3& r) {
  const glm::dvec3 size = glm::abs(r);
  if (size.x >= size.y && size.x >= size.z) {
    return r.x > 0.0 ? Face{0, glm::dvec2(-r.z, -r.y) / size.x} : Face{1, glm::dvec2(r.z, -r.y) / size.x};
  }
  if (size.y >= size.z) {
    return r.y > 0.0 ? Face{2, glm::dvec2(r.x, r.z) / size.y} : Face{3, glm::dvec2(r.x, -r.z) / size.y};
  }
  return r.z > 0.0 ? Face{4, glm::dvec2(r.x, -r.y) / size.z} : Face{5, glm::dvec2(-r.x, -r.y) / size.z};
}

TEST(CubeFaceDirection, IsWhereOpenGLReadsTheFace) {
  test::Places places(321U);
  for (int i = 0; i < 6000; ++i) {
    const glm::dvec2 place(places.between(-0.999, 0.999), places.between(-0.999, 0.999));
    const Face read = face_of(3.0 * f64::cube_face_direction(i % 6, place));
    ASSERT_EQ(read.face, i % 6);
    ASSERT_LT(glm::distance(read.place, place), 1e-12);
  }
}

}  // namespace
}  // namespace terrella
