#pragma once

#include <string>
#include <string_view>

#include "base/issues.hpp"
#include "scene/document.hpp"
#include "scene/json_reader.hpp"
#include "scene/parameters.hpp"

namespace terrella {

// The shortest JSON of the document: {"terrella":1,"preset":"storm","waves":{"steepness":0.9}}, with only what differs
// from its preset. load_json makes the same scene of it, value for value.
std::string to_json(const SceneDocument& document);

// Applies a scene's JSON to the document. A text that names a preset starts from that; one that does not starts from
// the document as it is, so give a new SceneDocument to load what to_json wrote. Members may also be written flat,
// {"waves.count": 8}. "title" and "about" are passed over. What cannot be applied is skipped and becomes an issue.
Issues load_json(SceneDocument& document, std::string_view text);

// A value as JSON writes it: 0.9, true, "#ff8800", "icosphere".
std::string json_value(const Value& value);

}  // namespace terrella
