#include "native/measure_folder.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

#include "base/file.hpp"
#include "base/text.hpp"

namespace terrella {

std::string make_folder(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  return error ? text_of(folder, ": cannot be made: ", error.message(), ".") : std::string();
}

std::string write_report(const std::string& folder, const std::string& json, const std::string& page) {
  for (const auto& [name, text] : {std::pair("report.json", &json), std::pair("index.html", &page)}) {
    const Result<Done> done = write_file_whole((std::filesystem::path(folder) / name).string(), *text);
    if (!done) return done.sentence();
  }
  return {};
}

}  // namespace terrella
