// The uniform blocks as C++ fills them lie where the driver reads them.
#include <gtest/gtest.h>

#include <cstddef>

#include "gl/program.hpp"
#include "native/egl_context.hpp"
#include "passes/frame.hpp"
#include "passes/layers.hpp"
#include "scene/uniforms.hpp"

namespace terrella {
namespace {

// The offset of a uniform in its block; -1 where the program does not have it.
GLint offset_of(const gl::Program& program, const char* name) {
  GLuint index = GL_INVALID_INDEX;
  glGetUniformIndices(program.id(), 1, &name, &index);
  if (index == GL_INVALID_INDEX) return -1;
  GLint offset = -1;
  glGetActiveUniformsiv(program.id(), 1, &index, GL_UNIFORM_OFFSET, &offset);
  return offset;
}

class Blocks : public testing::TestWithParam<Api> {
 protected:
  void SetUp() override {
    auto made = EglContext::make(GetParam());
    ASSERT_TRUE(made) << made.sentence();
    context_ = std::move(*made);
  }
  std::unique_ptr<EglContext> context_;
};

TEST_P(Blocks, SceneBlock) {
  gl::Program program("water/calm");
  program.use();
  int compared = 0;
  for (const BlockMember& member : block_members()) {
    const GLint offset = offset_of(program, member.name.c_str());
    if (offset < 0) continue;
    EXPECT_EQ(static_cast<std::size_t>(offset), member.offset) << member.name;
    ++compared;
  }
  EXPECT_GT(compared, 40);
  EXPECT_EQ(pack_scene({}).size() % 16, 0U);
}

TEST_P(Blocks, FrameBlock) {
  gl::Program program("water/waves");
  program.use();
  const std::pair<const char*, std::size_t> members[] = {{"clip_from_eye", offsetof(FrameBlock, clip_from_eye)},
                                                         {"eye_high", offsetof(FrameBlock, eye_high)},
                                                         {"eye_low", offsetof(FrameBlock, eye_low)},
                                                         {"ray_forward", offsetof(FrameBlock, ray_forward)},
                                                         {"sun_direction", offsetof(FrameBlock, sun_direction)},
                                                         {"sun_light", offsetof(FrameBlock, sun_light)},
                                                         {"cloud_turn", offsetof(FrameBlock, cloud_turn)},
                                                         {"cloud_moments", offsetof(FrameBlock, cloud_moments)},
                                                         {"sea", offsetof(FrameBlock, sea)},
                                                         {"ripple", offsetof(FrameBlock, ripple)},
                                                         {"levels", offsetof(FrameBlock, levels)},
                                                         {"ripple_turn", offsetof(FrameBlock, ripple_turn)},
                                                         {"fineness", offsetof(FrameBlock, fineness)},
                                                         {"depth", offsetof(FrameBlock, depth)},
                                                         {"channel", offsetof(FrameBlock, channel)}};
  for (const auto& [name, offset] : members) {
    EXPECT_EQ(offset_of(program, name), static_cast<GLint>(offset)) << name;
  }
}

TEST_P(Blocks, LayerBlock) {
  gl::Program program("ground/icosphere_near", "ground/icosphere");
  program.use();
  EXPECT_EQ(offset_of(program, "layer_anchor"), static_cast<GLint>(offsetof(LayerBlock, anchor)));
  EXPECT_EQ(offset_of(program, "layer_cell[0]"), static_cast<GLint>(offsetof(LayerBlock, cell)));
  EXPECT_EQ(offset_of(program, "layer_place[0]"), static_cast<GLint>(offsetof(LayerBlock, place)));
}

INSTANTIATE_TEST_SUITE_P(Contexts, Blocks, testing::Values(Api::core, Api::es),
                         [](const auto& context) { return context.param == Api::core ? "Core" : "Es"; });

}  // namespace
}  // namespace terrella
