// From light to a picture, on the CPU.
#pragma once

#include "base/image.hpp"

namespace terrella {

// An sRGB picture, 0..1, of linear light after exposure, with the noise that keeps 8 bits from showing bands. tone: as
// of lib/color.glsl. A fourth channel is the opacity, by which the light is weighted and the picture's colours are not.
Image developed(const Image& light, int tone);

}  // namespace terrella
