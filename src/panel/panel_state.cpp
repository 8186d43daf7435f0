#include "panel/panel_state.hpp"

#include <algorithm>

#include "panel/habits.hpp"
#include "scene/json.hpp"
#include "scene/parameters.hpp"
#include "scene/presets.hpp"

namespace terrella {
namespace {

std::string json_of(const Scene& scene) { return to_json({scene, std::string(kDefaultPreset)}); }

Scene scene_of(std::string_view json) {
  SceneDocument document;
  load_json(document, json);
  return document.scene;
}

constexpr int frames_until_scrolled = 4;

}  // namespace

void add_state(const PanelMemory& memory, NamedLines& lines) {
  lines.add("habits", habits_of(memory));
  for (const std::string_view path : memory.chance.locked) lines.add("locked", path);
  lines.add("search", memory.search.text.data());
  lines.add("scrolled", memory.scrolling.at);
  lines.add("keyboard", memory.keyboard.here);
  lines.add("tour_step", memory.tour.step);
  lines.add("picture_width", memory.picture.width);
  lines.add("picture_height", memory.picture.height);
  lines.add("picture_transparent", memory.picture.transparent);
  lines.add("mix_preset", memory.mix.preset);
  lines.add("mix_share", memory.mix.share);
  lines.add("mix_from", json_of(memory.mix.from));
  lines.add("mix_mixed", json_of(memory.mix.mixed));
}

void take_state(PanelMemory& memory, std::string_view text) {
  for (const NamedLine& line : lines_of(text)) {
    if (line.name == "habits") take_habits(memory, line.words);
    if (line.name == "locked") {
      if (const Parameter* parameter = find_parameter(line.words)) memory.chance.locked.insert(parameter->path);
    }
    if (line.name == "search") line.words.copy(memory.search.text.data(), memory.search.text.size() - 1);
    if (line.name == "scrolled") {
      memory.scrolling.wanted = static_cast<float>(line.number());
      memory.scrolling.frames_to_get = frames_until_scrolled;
    }
    if (line.name == "keyboard") memory.keyboard.wanted = line.number() != 0.0;
    if (line.name == "tour_step") memory.tour.step = static_cast<int>(line.number());
    if (line.name == "picture_width") memory.picture.width = static_cast<int>(line.number());
    if (line.name == "picture_height") memory.picture.height = static_cast<int>(line.number());
    if (line.name == "picture_transparent") memory.picture.transparent = line.number() != 0.0;
    if (line.name == "mix_preset") {
      if (const Preset* preset = find_preset(line.words)) memory.mix.preset = preset->name;
    }
    if (line.name == "mix_share") memory.mix.share = std::clamp(line.number(), 0.0, 1.0);
    if (line.name == "mix_from") memory.mix.from = scene_of(line.words);
    if (line.name == "mix_mixed") memory.mix.mixed = scene_of(line.words);
  }
}

}  // namespace terrella
