// The panel of sliders, made from the parameter table, drawn with Dear ImGui into its current frame.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "panel/memory.hpp"
#include "scene/document.hpp"

namespace terrella {

// What the panel shows beside the scene.
struct PanelFacts {
  struct Decision {
    std::string what, chosen, why;
  };

  double seconds = 0.0;  // of the planet's clock
  bool paused = false;
  bool can_undo = false, can_redo = false;
  bool comparing = false;  // the planet is shown as it was opened
  double frame_ms = 0.0;
  std::int64_t triangles = 0, gpu_bytes = 0, noise_evaluations = 0;
  int draw_calls = 0;
  std::string renderer;
  std::vector<Decision> decisions;   // what is modelled, how finely and why
  std::vector<std::string> notices;  // sentences about bad input, until dismissed
};

// What the user did to the panel in this frame, beside editing the document.
struct PanelWishes {
  bool scene_changed = false;   // some parameter has another value
  bool scene_replaced = false;  // a preset was chosen or everything reset
  bool preset_chosen = false;
  bool dragging = false;  // the hand is still on a value
  bool undo = false, redo = false;
  std::optional<bool> paused;
  std::optional<double> seconds;
  bool copy_link = false, copy_json = false, save_json = false, open_json = false, save_picture = false;
  bool dismiss_notices = false;

  bool operator==(const PanelWishes&) const = default;
};

// Where something that can be clicked lies, in pixels: "terrain" (a group's header), "terrain.height" (its slider),
// "terrain.height/reset", "terrain/random", "copy_link", "preset/storm",
// "notice/waves.count".
struct WidgetPlace {
  std::string name;
  float left, top, right, bottom;
};

class Panel {
 public:
  Panel();

  // Between ImGui::NewFrame and ImGui::Render. The panel takes the left edge of the window. Where `places` is given,
  // the place of every widget drawn is added to it.
  PanelWishes draw(SceneDocument& document, const PanelFacts& facts, std::vector<WidgetPlace>* places = nullptr);

  // Unfolds the panel and puts the keyboard into its search field, as the next frames are drawn.
  void start_search();

  // What is to be kept until the next visit, as a line of text (panel/habits.hpp).
  [[nodiscard]] std::string habits() const;
  void take_habits(std::string_view text);

  // Draws the planet anew by chance, but for what is locked.
  void surprise(SceneDocument& document);

  // Shows the list of keys, or closes it.
  void toggle_keys() { memory_.keys_shown = !memory_.keys_shown; }

 private:
  PanelMemory memory_;
};

// Colours, spacing and font for the current context of ImGui, at a scale of pixels per point. Call when the context is
// made or the scale changes, outside of a frame; a texture made of the old font must be made anew.
void style_panel(float scale);

}  // namespace terrella
