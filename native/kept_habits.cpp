#include "native/kept_habits.hpp"

#include <cstdlib>
#include <filesystem>

#include "base/file.hpp"
#include "panel/habits.hpp"

namespace terrella {
namespace {

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? std::string() : value;
}

}  // namespace

std::string habits_path(const std::string& state_home, const std::string& home) {
  const bool absolute = state_home.starts_with('/');  // the specification passes over others
  if (!absolute && home.empty()) return {};
  return (absolute ? state_home : home + "/.local/state") + "/terrella/panel";
}

std::string habits_path() { return habits_path(variable("XDG_STATE_HOME"), variable("HOME")); }

std::string kept_habits(const std::string& path) {
  if (path.empty()) return {};
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) keep_habits(path, std::string(kNewcomersHabits));
  Result<std::string> text = read_file(path, kLongestHabits);
  return text ? *text : std::string();
}

void keep_habits(const std::string& path, const std::string& habits) {
  if (path.empty()) return;
  std::error_code ignored;
  std::filesystem::create_directories(std::filesystem::path(path).parent_path(), ignored);
  static_cast<void>(write_file_whole(path, habits + "\n"));
}

}  // namespace terrella
