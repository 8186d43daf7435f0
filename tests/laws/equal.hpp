#pragma once

#include <gtest/gtest.h>

#include <glm/glm.hpp>

namespace terrella::test {

// Vectors that are the same but for rounding.
inline void expect_equal(const glm::dvec3& a, const glm::dvec3& b, double bound = 1e-12) {
  EXPECT_LE(glm::distance(a, b), bound) << a.x << " " << a.y << " " << a.z << ", " << b.x << " " << b.y << " " << b.z;
}

}  // namespace terrella::test
