#include "gl/mesh.hpp"

namespace terrella::gl {
namespace {

void upload(GLenum target, const BufferHandle& buffer, std::span<const std::byte> bytes) {
  glBindBuffer(target, buffer.name());
  glBufferData(target, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
}

void count_draw(std::int64_t triangles) {
  ++ledger().draw_calls;
  ledger().triangles += triangles;
}

}  // namespace

Mesh::Mesh(std::span<const glm::vec3> vertices, std::span<const std::uint32_t> indices) {
  glBindVertexArray(array_.name());
  upload(GL_ARRAY_BUFFER, vertices_, std::as_bytes(vertices));
  upload(GL_ELEMENT_ARRAY_BUFFER, indices_, std::as_bytes(indices));
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(glm::vec3), nullptr);
  glBindVertexArray(0);
  memory_.set(static_cast<std::int64_t>(vertices.size_bytes() + indices.size_bytes()));
}

void Mesh::draw(std::span<const Run> runs) const {
  glBindVertexArray(array_.name());
  for (const auto& [first, end] : runs) {
    const std::size_t offset = std::size_t{first} * 3 * sizeof(std::uint32_t);
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(3 * (end - first)), GL_UNSIGNED_INT,
                   reinterpret_cast<const void*>(offset));
    count_draw(std::int64_t{end} - first);
  }
}

Squares::Squares(std::span<const float> data, int vec4s_each)
    : count_(static_cast<GLsizei>(data.size() / (4 * static_cast<std::size_t>(vec4s_each)))) {
  glBindVertexArray(array_.name());
  upload(GL_ARRAY_BUFFER, vertices_, std::as_bytes(data));
  const auto stride = static_cast<GLsizei>(sizeof(float)) * 4 * vec4s_each;
  for (int i = 0; i < vec4s_each; ++i) {
    const auto offset = sizeof(float) * 4 * static_cast<std::size_t>(i);
    glEnableVertexAttribArray(static_cast<GLuint>(i));
    glVertexAttribPointer(static_cast<GLuint>(i), 4, GL_FLOAT, GL_FALSE, stride, reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(static_cast<GLuint>(i), 1);
  }
  glBindVertexArray(0);
  memory_.set(static_cast<std::int64_t>(data.size_bytes()));
}

void Squares::draw() const {
  if (count_ == 0) return;
  glBindVertexArray(array_.name());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count_);
  count_draw(2 * std::int64_t{count_});
}

void FullScreen::draw() const {
  glBindVertexArray(array_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  count_draw(1);
}

}  // namespace terrella::gl
