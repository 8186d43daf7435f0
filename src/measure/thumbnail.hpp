// Small pictures for a report.
#pragma once

#include "base/image.hpp"

namespace terrella {

// The picture at most so wide, each pixel the mean of those it stands for.
Image thumbnail(const Image& picture, int most_width = 240);

// A picture of one channel in colours: 0 black, over violet, red and orange to pale yellow for `most` and above, their
// lightness rising evenly.
Image heat(const Image& values, double most);

}  // namespace terrella
