// Where light is drawn, with depths that fall with distance.
#pragma once

#include <memory>

#include "gl/target.hpp"

namespace terrella {

// Directs drawing to a target of a size (pixels) and format, which is made anew where it is another, and clears it
// within the scissors: to a sky of three equal channels that nothing covers, and to the farthest. depth: not none.
void begin_light_target(std::unique_ptr<gl::Target>& target, int width, int height, gl::Format format, float sky,
                        gl::Depth depth = gl::Depth::drawn);

}  // namespace terrella
