// The panel of sliders, made from the parameter table, drawn with Dear ImGui into its current frame.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/named_lines.hpp"
#include "panel/camera_mode.hpp"
#include "panel/destination.hpp"
#include "panel/memory.hpp"
#include "scene/document.hpp"
#include "scene/quality_path.hpp"

namespace terrella {

// A picture of the planet to be saved.
struct PictureWish {
  int width = 1, height = 1;  // pixels
  bool transparent = false;   // the planet alone, with opacity

  bool operator==(const PictureWish&) const = default;
};

// What the panel shows beside the scene.
struct PanelFacts {
  struct Decision {
    std::string what, chosen, why;
  };

  double seconds = 0.0;  // of the planet's clock
  bool paused = false;
  bool can_undo = false, can_redo = false;
  bool comparing = false;  // the planet is shown as it was opened
  bool can_fill_screen = false;
  CameraMode camera_mode = CameraMode::orbit;
  double frame_ms = 0.0;
  std::int64_t triangles = 0, gpu_bytes = 0, noise_evaluations = 0;
  int draw_calls = 0;
  int width = 1, height = 1;  // of the window, pixels
  int largest_picture = 1;    // that can be saved, pixels along a side
  std::string renderer;
  const QualityStep* quality = nullptr;   // at which the planet is drawn, where quality.target_ms is held
  std::vector<unsigned> preset_pictures;  // textures, bottom row first, in the order of presets(): those drawn so far
  unsigned map = 0;                       // a texture, northernmost row first; 0: it is not there yet
  std::vector<Decision> decisions;        // what is modelled, how finely and why
  std::vector<std::string> notices;       // sentences about bad input, until dismissed
  std::vector<std::string> beyond;        // about what lies beyond the range of its technique, for as long as it does
};

// What the user did to the panel in this frame, beside editing the document.
struct PanelWishes {
  bool scene_changed = false;   // some parameter has another value
  bool scene_replaced = false;  // a preset was chosen or everything reset
  bool preset_chosen = false;
  bool dragging = false;    // the hand is still on a value
  bool takes_back = false;  // the change takes back that of a first click, for this was the second
  bool undo = false, redo = false;
  std::optional<CameraMode> camera_mode;
  std::optional<Destination> go_to;
  std::optional<bool> paused;
  std::optional<double> seconds;
  bool copy_link = false, copy_json = false, save_json = false, open_json = false;
  std::optional<PictureWish> save_picture;
  bool dismiss_notices = false;
  bool fill_screen = false;  // or leave it

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

  // Between ImGui::NewFrame and ImGui::Render. The panel takes the left edge of the window, or its lower one. Where
  // `places` is given, the place of every widget drawn is added to it.
  PanelWishes draw(SceneDocument& document, const PanelFacts& facts, std::vector<WidgetPlace>* places = nullptr);

  // Where it lies until a hand folds or unfolds it (see first_panel_place).
  void put_at(PanelPlace place) { memory_.first_place = place; }
  // What it hides of Dear ImGui's display, where that is so much that the planet makes room.
  [[nodiscard]] Covered covered() const;

  // Where it lies, as it was folded or unfolded last.
  [[nodiscard]] PanelPlace place() const { return memory_.place(); }

  // Whether it scrolls on although no finger does it: it wants to be drawn again.
  [[nodiscard]] bool moves() const { return memory_.finger.speed != 0.0F; }

  // Whether the last frame had a list of presets open, which shows PanelFacts::preset_pictures.
  [[nodiscard]] bool shows_presets() const { return memory_.presets_shown; }

  // Whether it had the map, which shows PanelFacts::map.
  [[nodiscard]] bool shows_map() const { return memory_.map_shown; }

  void unfold() { memory_.folded = false; }

  // What a button says to have copied was not.
  void forget_copied() { memory_.copied = {}; }

  // Unfolds the panel and puts the keyboard into its search field, as the next frames are drawn.
  void start_search();

  // Leads the keyboard into the panel, as the next frame is drawn: from then on Tab and arrows go from widget to
  // widget, Enter presses them, and Escape gives the keyboard back. Needs ImGuiConfigFlags_NavEnableKeyboard.
  void take_keyboard() { memory_.keyboard.wanted = true; }
  // Whether it has been there since the last frame.
  [[nodiscard]] bool has_keyboard() const { return memory_.keyboard.here; }
  // What is to be kept until the next visit, as a line of text (panel/habits.hpp).
  [[nodiscard]] std::string habits() const;
  void take_habits(std::string_view text);

  // What a panel of another program needs to go on with this one, habits included (panel/panel_state.hpp).
  void add_state(NamedLines& lines) const;
  void take_state(std::string_view text);

  // Draws the planet anew by chance, but for what is locked.
  void surprise(SceneDocument& document);

  // Shows the list of keys, or closes it.
  void toggle_keys() { memory_.keys_shown = !memory_.keys_shown; }

 private:
  PanelMemory memory_;
};

// Where the panel belongs: under the planet in a narrow window, and on a phone or tablet that is held upright. There,
// and on a phone that is held sideways, it is folded. width, height: of the window, points; fingers: they are what
// points.
PanelPlace first_panel_place(int width, int height, bool fingers);

// Colours, spacing and font for the current context of ImGui, at a scale of pixels per point. For fingers all rows are
// at least 44 points high. Call when the context is made or one of these changes, outside of a frame; a texture made of
// the old font must be made anew.
void style_panel(float scale, bool fingers = false);

}  // namespace terrella
