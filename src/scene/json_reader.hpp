#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "base/issues.hpp"
#include "scene/entries.hpp"

namespace terrella {

// The longest text that is read, in bytes.
inline constexpr std::size_t kLongestJson = 1'000'000;

// What a text should be.
struct JsonForm {
  std::string_view what = "scene";  // as sentences call it
  std::string_view list;            // the name of a member that is a list of objects; empty if there is none
};

// The entries of a scene's JSON, in their order, flat: {"waves": {"count": 8}} is the entry "waves.count", 8.
struct JsonReading {
  std::vector<Entry> entries;
  std::vector<std::vector<Entry>> list;  // those of each object of the form's list, which itself is an entry without a
                                         // value; what is no object is one entry without a name
  std::string trouble;                   // a sentence on where and why the reading stopped; empty if all was read
};

// Reads UTF-8 text that should be JSON. This is a reader of its own because a scene is flat and its author's mistakes
// are to cost as little as possible: where other readers give up the whole text, a number too large, a NaN or a value
// nested too deep is passed on as just one bad value, and a text that breaks off still yields what stands before. A
// value that no parameter takes (null, NaN, a list, an object within a group) has NaN for its value. Takes linear time
// and does not recurse, however deep the text.
JsonReading read_json(std::string_view text, const JsonForm& form = {});

// The same of any bytes. What is wrong with the text itself, its length, its encoding or its grammar, becomes an issue.
JsonReading read_given_json(std::string_view bytes, const JsonForm& form, Issues& issues);

}  // namespace terrella
