#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "base/issues.hpp"
#include "scene/document.hpp"

namespace terrella {

// The longest link that load_link reads, in bytes.
inline constexpr std::size_t kLongestLink = 65'536;

// The query of the document's link: preset=storm&waves.steepness=0.9, with only what differs from its preset; empty for
// the default scene. It needs no escapes. load_link makes the same scene of it, value for value.
std::string to_link(const SceneDocument& document);

// Applies a link's query, or a whole link (its query lies between '?' and '#'), to the document. As with load_json, a
// link that names no preset starts from the document as it is. The page's own keys, panel and pause, are passed over.
// What cannot be applied is skipped and becomes an issue.
Issues load_link(SceneDocument& document, std::string_view link);

}  // namespace terrella
