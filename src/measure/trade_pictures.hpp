// Pictures on the page of the trade, within the page itself.
#pragma once

#include <string>
#include <vector>

#include "measure/trade.hpp"

namespace terrella {

// What of FLIP is as bright as error maps go.
inline constexpr double brightest_error = 0.5;

// An <img> of a picture (3 channels, sRGB) or of an error map (1 channel). what: for who does not see it.
std::string picture_html(const Image& image, const std::string& what);

// The truth by each camera.
std::string truths_html(const TradeReport& report);

// A setting as cameras see it, each picture over its error map; the numbers of cameras are those of the report.
std::string sightings_html(const TradeReport& report, const Setting& setting, const std::vector<std::size_t>& cameras);

// The colours of error maps, with their values.
std::string heat_scale_html();

}  // namespace terrella
