#include "gl/mesh.hpp"

#include <vector>

namespace terrella::gl {
namespace {

void upload(GLenum target, const BufferHandle& buffer, std::span<const std::byte> bytes,
            GLenum usage = GL_STATIC_DRAW) {
  glBindBuffer(target, buffer.name());
  glBufferData(target, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), usage);
}

void count_draw(std::int64_t triangles) {
  ++ledger().draw_calls;
  ledger().triangles += triangles;
}

}  // namespace

Mesh::Mesh(std::span<const glm::vec3> vertices) : vertex_bytes_(static_cast<std::int64_t>(vertices.size_bytes())) {
  glBindVertexArray(array_.name());
  upload(GL_ARRAY_BUFFER, vertices_, std::as_bytes(vertices));
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.name());
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
  glBindVertexArray(0);
  memory_.set(vertex_bytes_);
}

void Mesh::set_indices(std::span<const std::uint32_t> indices) {
  glBindVertexArray(array_.name());
  upload(GL_ELEMENT_ARRAY_BUFFER, indices_, std::as_bytes(indices), GL_DYNAMIC_DRAW);
  memory_.set(vertex_bytes_ + static_cast<std::int64_t>(indices.size_bytes()));
}

void Mesh::draw(std::size_t first, std::size_t count) const {
  if (count == 0) return;
  glBindVertexArray(array_.name());
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                 reinterpret_cast<const void*>(sizeof(std::uint32_t) * first));
  count_draw(static_cast<std::int64_t>(count / 3));
}

Squares::Squares(int vec4s_each) : floats_each_(4 * static_cast<std::size_t>(vec4s_each)) {
  glBindVertexArray(array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, vertices_.name());
  const auto stride = static_cast<GLsizei>(sizeof(float) * floats_each_);
  for (int i = 0; i < vec4s_each; ++i) {
    const auto offset = sizeof(float) * 4 * static_cast<std::size_t>(i);
    glEnableVertexAttribArray(static_cast<GLuint>(i));
    glVertexAttribPointer(static_cast<GLuint>(i), 4, GL_FLOAT, GL_FALSE, stride, reinterpret_cast<const void*>(offset));
  }
  glBindVertexArray(0);
}

void Squares::set(std::span<const float> data) {
  // Each once for every corner: instances of so few vertices cost more than the memory.
  std::vector<float> vertices;
  vertices.reserve(6 * data.size());
  for (std::size_t first = 0; first < data.size(); first += floats_each_) {
    const auto square = data.subspan(first, floats_each_);
    for (int corner = 0; corner < 6; ++corner) vertices.insert(vertices.end(), square.begin(), square.end());
  }
  upload(GL_ARRAY_BUFFER, vertices_, std::as_bytes(std::span(vertices)), GL_DYNAMIC_DRAW);
  memory_.set(static_cast<std::int64_t>(6 * data.size_bytes()));
}

void Squares::draw(std::size_t first, std::size_t count) const {
  if (count == 0) return;
  glBindVertexArray(array_.name());
  glDrawArrays(GL_TRIANGLES, static_cast<GLint>(6 * first / floats_each_),
               static_cast<GLsizei>(6 * count / floats_each_));
  count_draw(static_cast<std::int64_t>(2 * count / floats_each_));
}

Instances::Instances(int vec4s_each, std::span<const glm::ivec2> vertices, std::span<const std::uint16_t> indices)
    : vec4s_each_(vec4s_each), bytes_(static_cast<std::int64_t>(vertices.size_bytes() + indices.size_bytes())) {
  glBindVertexArray(array_.name());
  upload(GL_ARRAY_BUFFER, vertices_, std::as_bytes(vertices));
  glEnableVertexAttribArray(static_cast<GLuint>(vec4s_each));
  glVertexAttribIPointer(static_cast<GLuint>(vec4s_each), 2, GL_INT, sizeof(glm::ivec2), nullptr);
  upload(GL_ELEMENT_ARRAY_BUFFER, indices_, std::as_bytes(indices));
  for (int i = 0; i < vec4s_each; ++i) {
    glEnableVertexAttribArray(static_cast<GLuint>(i));
    glVertexAttribDivisor(static_cast<GLuint>(i), 1);
  }
  glBindVertexArray(0);
  memory_.set(bytes_);
}

void Instances::set(std::span<const glm::vec4> data) {
  upload(GL_ARRAY_BUFFER, instances_, std::as_bytes(data), GL_STREAM_DRAW);
  memory_.set(bytes_ + static_cast<std::int64_t>(data.size_bytes()));
}

void Instances::draw(std::size_t first_index, std::size_t index_count, std::size_t first, std::size_t count) const {
  if (count == 0) return;
  glBindVertexArray(array_.name());
  glBindBuffer(GL_ARRAY_BUFFER, instances_.name());
  // What OpenGL ES has no base instance for.
  const auto stride = static_cast<std::size_t>(vec4s_each_) * sizeof(glm::vec4);
  for (int i = 0; i < vec4s_each_; ++i) {
    const std::size_t offset = first * stride + static_cast<std::size_t>(i) * sizeof(glm::vec4);
    glVertexAttribPointer(static_cast<GLuint>(i), 4, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                          reinterpret_cast<const void*>(offset));
  }
  glDrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(index_count), GL_UNSIGNED_SHORT,
                          reinterpret_cast<const void*>(sizeof(std::uint16_t) * first_index),
                          static_cast<GLsizei>(count));
  count_draw(static_cast<std::int64_t>(index_count / 3 * count));
}

void Strip::draw(int vertices) const {
  glBindVertexArray(array_.name());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, vertices);
  count_draw(vertices - 2);
}

void FullScreen::draw() const {
  glBindVertexArray(array_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  count_draw(1);
}

}  // namespace terrella::gl
