// Geometry on the GPU: one buffer of vertices, an optional one of indices.
#pragma once

#include <cstdint>
#include <span>

#include <glm/vec3.hpp>

#include "gl/handle.hpp"
#include "gl/ledger.hpp"

namespace terrella::gl {

// Triangles with one vec3 a vertex (attribute 0).
class Mesh {
 public:
  // vertices: positions or directions; indices: three a triangle, counter-clockwise from outside.
  Mesh(std::span<const glm::vec3> vertices, std::span<const std::uint32_t> indices);

  // Some of its triangles: whole runs of them, as [first, end).
  struct Run {
    std::uint32_t first, end;
  };
  void draw(std::span<const Run> runs) const;

 private:
  VertexArrayHandle array_;
  BufferHandle vertices_;
  BufferHandle indices_;
  Holding memory_;
};

// Squares with a fixed number of floats each, read as vec4 attributes 0, 1, …; the vertex shader makes the four corners
// from gl_VertexID.
class Squares {
 public:
  // data: vec4s_each * 4 floats a square.
  Squares(std::span<const float> data, int vec4s_each);

  void draw() const;

 private:
  VertexArrayHandle array_;
  BufferHandle vertices_;
  GLsizei count_;
  Holding memory_;
};

// One triangle that covers the whole picture; its vertex shader makes the corners from gl_VertexID.
class FullScreen {
 public:
  void draw() const;

 private:
  VertexArrayHandle array_;
};

}  // namespace terrella::gl
