// Geometry on the GPU: one buffer of vertices, an optional one of indices.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "gl/handle.hpp"
#include "gl/ledger.hpp"

namespace terrella::gl {

// Triangles with one vec3 a vertex (attribute 0).
class Mesh {
 public:
  // vertices: positions or directions. There are no triangles yet.
  explicit Mesh(std::span<const glm::vec3> vertices);

  // indices: three a triangle, counter-clockwise from outside; they replace those before.
  void set_indices(std::span<const std::uint32_t> indices);

  // first, count: of the indices.
  void draw(std::size_t first, std::size_t count) const;

 private:
  VertexArrayHandle array_;
  BufferHandle vertices_;
  BufferHandle indices_;
  std::int64_t vertex_bytes_;
  Holding memory_;
};

// Squares with a fixed number of floats each, read as vec4 attributes 0, 1, …; the vertex shader makes the corners of
// their two triangles from gl_VertexID modulo 6.
class Squares {
 public:
  explicit Squares(int vec4s_each);

  // data: vec4s_each * 4 floats a square; replaces what was there.
  void set(std::span<const float> data);

  // first, count: of the floats, whole squares.
  void draw(std::size_t first, std::size_t count) const;

 private:
  VertexArrayHandle array_;
  BufferHandle vertices_;
  std::size_t floats_each_;
  Holding memory_;
};

// Triangles drawn many times over: each instance has a fixed number of vec4 attributes 0, 1, …, and each vertex an
// ivec2 after those.
class Instances {
 public:
  // indices: three a triangle, as one list of lists.
  Instances(int vec4s_each, std::span<const glm::ivec2> vertices, std::span<const std::uint16_t> indices);

  // data: vec4s_each a piece; replaces what was there.
  void set(std::span<const glm::vec4> data);

  // first_index, index_count: of the indices; first, count: of the instances.
  void draw(std::size_t first_index, std::size_t index_count, std::size_t first, std::size_t count) const;

 private:
  VertexArrayHandle array_;
  BufferHandle vertices_;
  BufferHandle indices_;
  BufferHandle instances_;
  int vec4s_each_;
  std::int64_t bytes_;  // but for the instances
  Holding memory_;
};

// A strip of triangles whose vertex shader makes it from gl_VertexID.
class Strip {
 public:
  // vertices: 3 or more.
  void draw(int vertices) const;

 private:
  VertexArrayHandle array_;
};

// One triangle that covers the whole picture; its vertex shader makes the corners from gl_VertexID.
class FullScreen {
 public:
  void draw() const;

 private:
  VertexArrayHandle array_;
};

}  // namespace terrella::gl
