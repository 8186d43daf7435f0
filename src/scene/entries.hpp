#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/issues.hpp"
#include "scene/document.hpp"
#include "scene/parameters.hpp"

// What a scene's JSON and a scene's link have in common: a list of entries that are applied one by one.
namespace terrella {

// The version of the scenes that this program writes and reads.
inline constexpr int kSceneVersion = 1;

// A key and its value as the user gave them.
struct Entry {
  std::string path;            // "waves.steepness", or "preset"
  std::string text;            // as given, to be quoted in a sentence
  std::optional<Value> value;  // none where all that is known is the text, as in a link
};

// Sets the entry's parameter, or says why not and leaves the scene as it was.
std::optional<Issue> assign_entry(Scene& scene, const Entry& entry);

// Applies the entries to the document: "terrella" is checked, a "preset" starts the scene anew from there, wherever it
// stands, and the others set parameters. Keys in `not_ours` are passed over. What cannot be applied becomes an issue
// and changes nothing.
void apply_entries(SceneDocument& document, std::span<const Entry> entries, std::span<const std::string_view> not_ours,
                   Issues& issues);

}  // namespace terrella
