// The panel by keyboard alone, by Dear ImGui's own navigation: who has the keyboard, and what its mark looks like.
#pragma once

#include "panel/memory.hpp"

namespace terrella {

// Between Begin and End of a window: the widget that was used last takes the keyboard, or the first one, and is marked.
void take_keyboard();

// The widget that was used last is no longer there.
void forget_focus();

// Gives the keyboard to the widget that is drawn next, also after a press beside all windows, which Dear ImGui's own
// function does not outlive.
void focus_next_widget();

// Whether a widget of the panel has the keyboard and is marked.
bool keyboard_is_here();

// Around the widget drawn last, where that does not draw the mark itself.
void mark_focus();

// Puts the keyboard back on a widget of the current window that something else has stood in for.
void focus_again(const char* id);

// Steps that the arrow keys take on the slider drawn last, which keeps them from leading to its neighbours: -1, 0 or 1,
// and a tenth of that with Ctrl.
double steps_by_arrows();

// Whether the widget drawn last was pressed by a key.
bool pressed_by_key();

// After all widgets of a frame. Escape gives the keyboard back to the planet, unless it was for an open list, a value
// or the list of keys.
void give_back_keyboard(Keyboard& keyboard, bool keys_shown);

}  // namespace terrella
