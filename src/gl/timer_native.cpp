#include <algorithm>
#include <string_view>

#include "gl/caps.hpp"
#include "gl/timer.hpp"

namespace terrella::gl {
namespace {

// Names by which such drivers call themselves.
constexpr std::string_view on_the_cpu[] = {"llvmpipe", "softpipe", "SwiftShader", "Software", "swrast"};

bool draws_on_the_cpu() {
  return std::any_of(std::begin(on_the_cpu), std::end(on_the_cpu),
                     [](std::string_view name) { return renderer_name().find(name) != std::string::npos; });
}

// Bits in which the driver counts; 0 where it has such queries in name only.
int counter_bits() {
  GLint bits = 0;
  if (!caps().es) {
    glGetQueryiv(GL_TIME_ELAPSED, GL_QUERY_COUNTER_BITS, &bits);
  } else if (epoxy_has_gl_extension("GL_EXT_disjoint_timer_query")) {
    glGetQueryivEXT(GL_TIME_ELAPSED_EXT, GL_QUERY_COUNTER_BITS_EXT, &bits);
  }
  return bits;
}

// Whether something since this was last asked made times meaningless, such as a change of the GPU's clock.
bool was_disturbed() {
  GLint disjoint = 0;
  if (caps().es) glGetIntegerv(GL_GPU_DISJOINT_EXT, &disjoint);
  return disjoint != 0;
}

}  // namespace

bool has_timer() { return !draws_on_the_cpu() && counter_bits() > 0; }

void Timer::begin() {
  was_disturbed();
  glBeginQuery(GL_TIME_ELAPSED, query_.name());
}

std::optional<double> Timer::end() {
  glEndQuery(GL_TIME_ELAPSED);
  GLuint64 nanoseconds = 0;
  if (caps().es) {
    glGetQueryObjectui64vEXT(query_.name(), GL_QUERY_RESULT_EXT, &nanoseconds);
  } else {
    glGetQueryObjectui64v(query_.name(), GL_QUERY_RESULT, &nanoseconds);
  }
  if (was_disturbed()) return std::nullopt;
  return 1e-6 * static_cast<double>(nanoseconds);
}

}  // namespace terrella::gl
