#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/entries.hpp"

namespace terrella {

// The entries of a scene's JSON, in their order, flat: {"waves": {"count": 8}} is the entry "waves.count", 8.
struct JsonReading {
  std::vector<Entry> entries;
  std::string trouble;  // a sentence on where and why the reading stopped; empty if all was read
};

// Reads UTF-8 text that should be JSON. This is a reader of its own because a scene is flat and its author's mistakes
// are to cost as little as possible: where other readers give up the whole text, a number too large, a NaN or a value
// nested too deep is passed on as just one bad value, and a text that breaks off still yields what stands before. A
// value that no parameter takes (null, NaN, a list, an object within a group) has NaN for its value. Takes linear time
// and does not recurse, however deep the text.
JsonReading read_json(std::string_view text);

}  // namespace terrella
