#include "panel/keys.hpp"

#include "base/text.hpp"

namespace terrella {
namespace {

constexpr KeyLine planet_lines[] = {
    {"1, 2, 3", "orbit the planet, fly, walk"},
    {"Drag", "turn the planet"},
    {"Wheel, + and -", "nearer, away"},
    {"Right drag, Ctrl+drag", "look around"},
    {"Arrows, W A S D", "move over the ground"},
    {"Q and E", "turn left, right"},
    {"R and F, Page Up and Down", "look up, down"},
};

constexpr KeyLine flight_lines[] = {
    {"W A S D, arrows", "along the view, sideways"},
    {"T and G", "rise, sink"},
    {"Q and E", "roll left, right"},
    {"Drag", "look around"},
    {"Wheel, + and -", "faster, slower"},
    {"Shift, held", "four times as fast"},
};

constexpr KeyLine foot_lines[] = {
    {"W A S D, arrows", "walk"},
    {"Shift, held", "run"},
    {"Space", "jump"},
    {"Drag", "look around"},
};

constexpr KeyLine scene_lines[] = {
    {"Space", "stop the clock, let it go on"},
    {"C, held", "the planet as it was opened"},
    {"N", "a new planet by chance, but for what is locked"},
    {"Ctrl+Z", "undo"},
    {"Ctrl+Shift+Z, Ctrl+Y", "redo"},
    {"Ctrl+V", "load a scene from the clipboard, as JSON or link"},
};

constexpr KeyLine panel_lines[] = {
    {"H", "hide the panel, show it"},
    {"Shift+F", "fill the screen, leave it"},
    {"/", "search a parameter"},
    {"Tab", "go into the panel, and from row to row"},
    {"Arrows, Enter", "in the panel: go on, press"},
    {"Escape", "end the search or the tour, close this list, leave the panel"},
    {"?", "show this list, close it"},
};

constexpr KeyLine slider_lines[] = {
    {"Drag", "change the value"},
    {"Wheel", "change it in small steps"},
    {"Ctrl with drag or wheel", "a tenth as fast"},
    {"Double click, Ctrl+click", "type the value"},
    {"Left and Right, Enter", "by keyboard: small steps, type the value"},
};

constexpr KeyLine finger_lines[] = {
    {"One finger", "turn the planet, scroll the panel"},         {"Two fingers", "nearer, away, twist and look around"},
    {"Draw along a slider, tap it", "change the value, set it"}, {"Tap a slider twice", "type the value"},
    {"Hold a name", "what it is, and what it may be"},
};

constexpr KeyGroup groups_of_keys[] = {
    {"On the planet", planet_lines},   {"In flight", flight_lines}, {"On foot", foot_lines},
    {"The scene", scene_lines},        {"The panel", panel_lines},  {"On a slider", slider_lines},
    {"By finger", finger_lines, true},
};

}  // namespace

std::span<const KeyGroup> key_groups() { return groups_of_keys; }

std::string keys_text() {
  std::string text = "# Keys, mouse and fingers\n";
  for (const KeyGroup& group : key_groups()) {
    text += text_of("\n## ", group.title, "\n\n| hand | does |\n| --- | --- |\n");
    for (const KeyLine& line : group.lines) text += text_of("| ", line.keys, " | ", line.does, " |\n");
  }
  return text;
}

}  // namespace terrella
