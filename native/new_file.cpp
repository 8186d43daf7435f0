#include "native/new_file.hpp"

#include <filesystem>

#include "base/file.hpp"
#include "base/text.hpp"

namespace terrella {
namespace {

bool is_taken(const std::string& name) {
  std::error_code ignored;
  return std::filesystem::symlink_status(name, ignored).type() != std::filesystem::file_type::not_found;
}

}  // namespace

Result<std::string> save_new_file(const std::string& stem, const std::string& extension, std::string_view bytes) {
  constexpr int most_tried = 10000;
  std::string name = stem + extension;
  for (int i = 2; i <= most_tried && is_taken(name); ++i) name = text_of(stem, '-', i, extension);
  if (is_taken(name)) return Failure{text_of("There are too many files named ", stem, " in this folder.")};
  if (const Result<Done> done = write_file_whole(name, bytes); !done) return Failure{done.sentence()};
  return name;
}

}  // namespace terrella
