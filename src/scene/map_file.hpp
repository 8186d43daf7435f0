#pragma once

#include <memory>
#include <string>

#include "base/height_map.hpp"

namespace terrella {

// A file that a scene names, and what it holds once somebody has found and read it: a scene's text has only the name.
struct MapFile {
  std::string name;     // UTF-8; empty: none is asked for
  SharedHeightMap map;  // null: not read, or not found
  bool operator==(const MapFile&) const = default;
};

// Bytes that a name may have.
inline constexpr std::size_t longest_file_name = 200;

}  // namespace terrella
