// JSON that is written once and never read again: its texts put together.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace terrella {

// {"a":1,"b":[]}. members: names, which need no escapes, and values as JSON; those without a value are left out.
std::string json_object(std::initializer_list<std::pair<std::string_view, std::string>> members);

// [1,2]. values: as JSON.
std::string json_list(const std::vector<std::string>& values);

// ["a","b"]. Texts must be UTF-8.
std::string json_texts(const std::vector<std::string>& texts);

}  // namespace terrella
