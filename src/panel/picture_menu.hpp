// What picture of the planet to save: with or without the sky, and how large.
#pragma once

#include "panel/sheet.hpp"

namespace terrella {

// Opens it at the pointer, as the next frame is drawn.
void open_picture_menu();

// Nothing unless it is open. To choose a size is to wish for the picture.
void picture_menu(Sheet& sheet);

}  // namespace terrella
