#include "native/measuring.hpp"

#include <filesystem>
#include <system_error>

#include "base/file.hpp"
#include "base/text.hpp"
#include "gl/caps.hpp"

namespace terrella {

std::string beyond_this_machine() {
  if (gl::caps().full_float_targets) return {};
  return "This machine's OpenGL cannot draw to 32 bit floats, which measuring needs.";
}

std::string make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  return error ? text_of(folder, ": cannot be made: ", error.message(), ".") : std::string();
}

std::string write_files(const std::string& folder, const std::vector<NamedText>& files) {
  for (const NamedText& file : files) {
    const Result<Done> done = write_file_whole((std::filesystem::path(folder) / file.name).string(), file.text);
    if (!done) return done.sentence();
  }
  return {};
}

}  // namespace terrella
