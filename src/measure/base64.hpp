#pragma once

#include <string>
#include <string_view>

namespace terrella {

// Bytes as RFC 4648 writes them in letters, with padding.
std::string base64(std::string_view bytes);

}  // namespace terrella
