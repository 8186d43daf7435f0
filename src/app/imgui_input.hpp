// Hands to Dear ImGui, in pixels.
#pragma once

#include "app/input.hpp"

namespace terrella::imgui_input {

void move(double x, double y);
void leave();
void button(int button, bool down);
void wheel(double notches);
void key(Key key, bool down, Modifiers modifiers);
void text(unsigned codepoint);

}  // namespace terrella::imgui_input
