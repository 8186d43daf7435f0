#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <system_error>

#include "base/file.hpp"
#include "base/text.hpp"

namespace terrella {
namespace {

namespace fs = std::filesystem;

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

Failure failure(std::string_view deed, const std::string& path, int error) {
  return {text_of(shortened(path, 200), ": cannot be ", deed, ": ", std::strerror(error), ".")};
}

// 0, or the errno of what went wrong. Closing is part of writing: a full disk may show only then.
int write_all(File file, std::string_view bytes) {
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
  const int error = errno;
  if (!written) return error;
  return std::fclose(file.release()) == 0 ? 0 : errno;
}

bool is_device_or_pipe(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

// Where a symbolic link leads, so that the link outlives the renaming.
std::string target_of(const std::string& path) {
  std::error_code error;
  const fs::path target = fs::canonical(path, error);
  return error ? path : target.string();
}

}  // namespace

Result<std::string> read_file(const std::string& path, std::size_t max_bytes) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return failure("read", path, EISDIR);
  const File file(std::fopen(path.c_str(), "rb"));
  if (!file) return failure("read", path, errno);

  // One byte more than allowed is asked for, to see whether the file goes on; a size need not be known, nor be true.
  std::string bytes;
  constexpr std::size_t kChunk = 1 << 16;
  while (bytes.size() <= max_bytes) {
    const std::size_t before = bytes.size();
    const std::size_t wanted = std::min(kChunk, max_bytes - before + 1);
    bytes.resize(before + wanted);
    const std::size_t got = std::fread(bytes.data() + before, 1, wanted, file.get());
    bytes.resize(before + got);
    if (got < wanted) break;
  }
  if (std::ferror(file.get()) != 0) return failure("read", path, errno);
  if (bytes.size() > max_bytes) {
    return Failure{text_of(shortened(path, 200), ": is longer than the ", max_bytes, " bytes that are read.")};
  }
  return bytes;
}

Result<Done> write_file_whole(const std::string& path, std::string_view bytes) {
  if (is_device_or_pipe(path)) {
    File device(std::fopen(path.c_str(), "wb"));
    if (!device) return failure("written", path, errno);
    const int error = write_all(std::move(device), bytes);
    return error == 0 ? Result<Done>(Done{}) : failure("written", path, error);
  }

  const std::string target = target_of(path);
  const std::string temporary = text_of(target, ".", getpid(), ".part");
  File file(std::fopen(temporary.c_str(), "wbx"));
  if (!file) return failure("written", path, errno);
  int error = write_all(std::move(file), bytes);
  if (error == 0 && std::rename(temporary.c_str(), target.c_str()) != 0) error = errno;
  if (error == 0) return Done{};
  std::remove(temporary.c_str());
  return failure("written", path, error);
}

}  // namespace terrella
