#include "scene/entries.hpp"

#include <algorithm>
#include <set>

#include "base/text.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

constexpr std::string_view kVersionKey = "terrella", kPresetKey = "preset";

void check_version(const Entry& entry, Issues& issues) {
  if (entry.text == text_of(kSceneVersion)) return;
  issues.add(entry.path, text_of("version ", shortened(entry.text), " is not known; this program reads version ",
                                 kSceneVersion, '.'));
}

void start_from_preset(SceneDocument& document, const Entry& entry, Issues& issues) {
  const Preset* preset = find_preset(entry.text);
  if (preset == nullptr) {
    issues.add(no_such_preset(entry.text));
    return;
  }
  document = {preset->scene, preset->name};
}

}  // namespace

std::optional<Issue> assign_entry(Scene& scene, const Entry& entry) {
  if (!entry.value) return assign_text(scene, entry.path, entry.text);
  const Parameter* parameter = find_parameter(entry.path);
  if (parameter != nullptr) return assign(scene, *parameter, *entry.value, entry.text);
  if (find_group(entry.path) != nullptr) {
    return Issue{entry.path, text_of(shortened(entry.text), " is not a group of parameters, {…}.")};
  }
  return no_such_parameter(entry.path);
}

void apply_entries(SceneDocument& document, std::span<const Entry> entries, std::span<const std::string_view> not_ours,
                   Issues& issues) {
  for (const Entry& entry : entries) {
    if (entry.path == kVersionKey) check_version(entry, issues);
    if (entry.path == kPresetKey) start_from_preset(document, entry, issues);
  }
  std::set<std::string_view> seen;
  for (const Entry& entry : entries) {
    if (std::find(not_ours.begin(), not_ours.end(), entry.path) != not_ours.end()) continue;
    if (!seen.insert(entry.path).second) {
      issues.add(shortened(entry.path), "is given more than once; the last one counts.");
    }
    if (entry.path == kVersionKey || entry.path == kPresetKey) continue;
    if (issues.full() && find_parameter(entry.path) == nullptr) {
      issues.add_unlisted();  // finding the nearest name takes time, which hostile input would multiply
    } else if (auto issue = assign_entry(document.scene, entry)) {
      issues.add(std::move(*issue));
    }
  }
}

}  // namespace terrella
