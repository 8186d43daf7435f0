// Settings and numbers as a page tells them.
#pragma once

#include <string>

#include "measure/trade.hpp"

namespace terrella {

// Three digits, or all of a large number's: "0.0843", "12.3", "40320".
std::string figure(double value);

// "34.2 dB"
std::string decibels(double psnr);

// "12.3 %" of a part
std::string percent(double part);

// "7.45 (7.3 to 7.6)"
std::string with_spread(const Spread& spread);

// What of a setting differs from another one: "ground texels 512 to 64, antialias true to false"; empty where nothing
// does.
std::string changes(const Scene& from, const Scene& to);

// "as the scene has it", or what is different: "ground texels 64, antialias false".
std::string setting_in_words(const Setting& setting, const Scene& scene);

// The quality's value with its unit: "0.75 px".
std::string value_in_words(const Knob& knob, const Value& value);

}  // namespace terrella
