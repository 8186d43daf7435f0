// The panel of sliders, made from the parameter table, drawn with Dear ImGui into its current frame.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/document.hpp"

namespace terrella {

// What the panel shows beside the scene.
struct PanelFacts {
  struct Decision {
    std::string what, chosen, why;
  };

  double seconds = 0.0;  // of the planet's clock
  bool paused = false;
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
  bool dragging = false;        // the hand is still on a value
  std::optional<bool> paused;
  std::optional<double> seconds;
  bool copy_link = false, copy_json = false, save_json = false, open_json = false, save_picture = false;
  bool dismiss_notices = false;
  bool hide = false;
};

class Panel {
 public:
  // Between ImGui::NewFrame and ImGui::Render. The panel takes the left edge of the window.
  PanelWishes draw(SceneDocument& document, const PanelFacts& facts);
};

// Colours and spacing for a context of ImGui, at a scale of pixels per point. Call when it is made or the scale changes.
void style_panel(float scale);

}  // namespace terrella
