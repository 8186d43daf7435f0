#include "native/picture_series.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <utility>

#include "base/file.hpp"
#include "base/text.hpp"

namespace terrella {
namespace {

bool is_there(const std::string& path) {
  std::error_code ignored;
  return std::filesystem::symlink_status(path, ignored).type() != std::filesystem::file_type::not_found;
}

// The first line of a text, taken from it, without what only the JSON around it needs.
std::string take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  while (line.starts_with(' ')) line.remove_prefix(1);
  while (line.ends_with(',')) line.remove_suffix(1);
  return shortened(line, 100);
}

// "there "size": "160x90", now "size": "320x180"", of the first lines that differ.
std::string difference(std::string_view there, std::string_view now) {
  std::string line_there, line_now;
  while (line_there == line_now && !(there.empty() && now.empty())) {
    line_there = take_line(there);
    line_now = take_line(now);
  }
  return text_of("there ", line_there.empty() ? "nothing" : line_there, ", now ",
                 line_now.empty() ? "nothing" : line_now);
}

}  // namespace

PictureSeries::PictureSeries(const std::string& out, int count, std::string about)
    : name_(out.substr(0, out.size() - 4)),
      extension_(out.substr(out.size() - 4)),
      count_(count),
      about_(std::move(about)) {}

std::string PictureSeries::file(int index) const {
  const std::size_t digits = std::max<std::size_t>(4, text_of(count_).size());
  const std::string number = text_of(index + 1);
  return text_of(name_, '-', std::string(digits - number.size(), '0'), number, extension_);
}

std::optional<Issue> PictureSeries::in_the_way() const {
  if (is_there(about_file())) {
    const Result<std::string> there = read_file(about_file(), about_.size() + 1'000'000);
    if (!there) return Issue{"", there.sentence()};
    if (*there == about_) return std::nullopt;
    return Issue{about_file(), text_of("pictures of something else are there already: ", difference(*there, about_),
                                       "; give another --out, or delete this file and ", name_, "-*", extension_, '.')};
  }
  for (int i = 0; i < count_; ++i) {
    if (is_there(file(i))) {
      return Issue{file(i), text_of("is there already, and no ", about_file(),
                                    " tells what it shows; give another --out, or delete it.")};
    }
  }
  return std::nullopt;
}

Result<Done> PictureSeries::begin() const {
  return is_there(about_file()) ? Result<Done>(Done{}) : write_file_whole(about_file(), about_);
}

bool PictureSeries::has(int index, const PictureTask& task) const {
  constexpr std::size_t longest = std::size_t{1} << 33;  // bytes: no picture is longer
  if (!is_there(file(index))) return false;
  const Result<std::string> bytes = read_file(file(index), longest);
  return bytes && is_whole(task, *bytes);
}

}  // namespace terrella
