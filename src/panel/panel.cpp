#include "panel/panel.hpp"

#include <imgui.h>

namespace terrella {

PanelWishes Panel::draw(SceneDocument&, const PanelFacts&) { return {}; }

void style_panel(float) {}

}  // namespace terrella
