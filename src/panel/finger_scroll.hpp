// A finger that is drawn up or down over the panel scrolls it, and throws it.
#pragma once

#include "panel/memory.hpp"

namespace terrella {

// Whether what moves the pointer is a finger, which cannot hover.
bool by_finger();

// How far (pixels) a finger moves before it is told whether it draws along a row or scrolls.
float finger_rest();

// After all widgets of a frame. A press that turns out to scroll is taken from the widget under it.
void scroll_by_finger(FingerScroll& finger);

}  // namespace terrella
