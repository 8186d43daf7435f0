#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/result.hpp"

// Files of the desktop program; the browser build has none.
namespace terrella {

// The file's bytes. Fails with a sentence if it cannot be read, is a folder, or is longer than max_bytes.
Result<std::string> read_file(const std::string& path, std::size_t max_bytes);

// Writes a file so that it is there whole or not at all: into a temporary file beside it, renamed when complete. What
// was there before stays until then, and stays if this fails. Devices and pipes are written to directly.
Result<Done> write_file_whole(const std::string& path, std::string_view bytes);

}  // namespace terrella
