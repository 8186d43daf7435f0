#include "scene/presets.hpp"

#include <algorithm>
#include <vector>

#include "base/check.hpp"
#include "base/text.hpp"
#include "scene/document.hpp"
#include "scene/entries.hpp"
#include "scene/json_reader.hpp"
#include "scene/preset_texts.hpp"

namespace terrella {
namespace {

// A preset's text is the program's own, so that a mistake in it is a programmer's.
Preset read_preset(const PresetText& file) {
  const JsonReading reading = read_json(file.json);
  CHECK(reading.trouble.empty(), "preset ", file.name, ": ", reading.trouble);
  Preset preset;
  preset.name = file.name;
  for (const Entry& entry : reading.entries) {
    if (entry.path == "terrella") {
      CHECK(entry.text == text_of(kSceneVersion), "preset ", file.name, ": version ", entry.text);
    } else if (entry.path == "title") {
      preset.title = entry.text;
    } else if (entry.path == "about") {
      preset.about = entry.text;
    } else {
      const auto issue = assign_entry(preset.scene, entry);
      CHECK(!issue, "preset ", file.name, ": ", issue->text());
    }
  }
  return preset;
}

std::vector<Preset> read_presets() {
  std::vector<Preset> all;
  for (const PresetText& file : preset_texts()) all.push_back(read_preset(file));
  const auto first =
      std::find_if(all.begin(), all.end(), [](const Preset& preset) { return preset.name == kDefaultPreset; });
  if (first != all.end()) std::rotate(all.begin(), first, first + 1);
  CHECK(!all.empty() && all[0].name == kDefaultPreset && all[0].scene == Scene{}, "no default preset");
  return all;
}

}  // namespace

std::span<const Preset> presets() {
  static const std::vector<Preset> all = read_presets();
  return all;
}

const Preset* find_preset(std::string_view name) {
  for (const Preset& preset : presets()) {
    if (preset.name == name) return &preset;
  }
  return nullptr;
}

Issue no_such_preset(std::string_view name) {
  std::vector<std::string_view> names;
  for (const Preset& preset : presets()) names.push_back(preset.name);
  return {"preset", text_of("there is no preset \"", shortened(name), '"', did_you_mean(nearest_name(name, names)))};
}

}  // namespace terrella
