// Geometry on the GPU: one buffer of vertices, an optional one of indices.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "gl/handle.hpp"
#include "gl/ledger.hpp"

namespace terrella::gl {

// Triangles with one vec3 a vertex (attribute 0), of which some are chosen to be drawn, in one draw call.
class Mesh {
 public:
  // vertices: positions or directions; indices: three a triangle, counter-clockwise from outside. They must outlive the
  // mesh.
  Mesh(std::span<const glm::vec3> vertices, std::span<const std::uint32_t> indices);

  // Triangles [first, end).
  struct Run {
    std::uint32_t first, end;
    bool operator==(const Run&) const = default;
  };
  // Draws the triangles of the runs. Uploads their indices where the runs differ from those of the last time.
  void draw(std::vector<Run> runs);

 private:
  void choose(std::vector<Run> runs);

  VertexArrayHandle array_;
  BufferHandle vertices_;
  BufferHandle chosen_;
  std::span<const std::uint32_t> indices_;
  std::vector<Run> runs_;
  std::int64_t triangles_ = 0;
  std::int64_t vertex_bytes_;
  Holding memory_;
};

// Squares with a fixed number of floats each, read as vec4 attributes 0, 1, …; the vertex shader makes the four corners
// from gl_VertexID.
class Squares {
 public:
  explicit Squares(int vec4s_each);

  // data: vec4s_each * 4 floats a square; replaces what was there.
  void set(std::span<const float> data);

  void draw() const;

 private:
  VertexArrayHandle array_;
  BufferHandle vertices_;
  std::size_t floats_each_;
  GLsizei count_ = 0;
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
