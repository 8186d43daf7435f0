#include "gl/timer.hpp"

#include <gtest/gtest.h>

#include "gl/caps.hpp"
#include "gl/target.hpp"
#include "native/egl_context.hpp"

namespace terrella {
namespace {

TEST(Timer, TimesWhatIsDrawnAndIsTrustedOnlyWhereAGpuDraws) {
  const auto context = EglContext::make(Api::core);
  ASSERT_TRUE(context) << context.sentence();
  const bool on_the_cpu = gl::renderer_name().find("llvmpipe") != std::string::npos;
  EXPECT_FALSE(on_the_cpu && gl::has_timer());
  const gl::Target target(256, 256, gl::Format::rgba8, gl::Depth::none);
  gl::Timer timer;
  for (int i = 0; i < 3; ++i) {  // one after the other
    timer.begin();
    target.begin();
    glClear(GL_COLOR_BUFFER_BIT);
    const auto ms = timer.end();
    ASSERT_TRUE(ms);
    EXPECT_GE(*ms, 0.0);
    EXPECT_TRUE(*ms < 10'000.0 || !gl::has_timer()) << *ms;  // llvmpipe tells of hours
  }
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
}

}  // namespace
}  // namespace terrella
