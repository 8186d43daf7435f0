#include "measure/machine.hpp"

#include <fstream>
#include <thread>

#include "gl/api.hpp"
#include "gl/caps.hpp"

namespace terrella {
namespace {

// As Linux tells it; empty elsewhere.
std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return {};
}

}  // namespace

Machine this_machine() {
  Machine machine;
  machine.renderer = gl::renderer_name();
  const auto* version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
  machine.gl_version = version == nullptr ? "" : version;
  machine.cpu = cpu_model();
  machine.cores = static_cast<int>(std::thread::hardware_concurrency());
  return machine;
}

}  // namespace terrella
