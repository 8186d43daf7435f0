#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace terrella {

// An sRGB colour of 8 bits a channel.
struct Color {
  std::uint8_t r = 0, g = 0, b = 0;

  static constexpr Color from_hex(std::uint32_t rrggbb) {
    return {static_cast<std::uint8_t>(rrggbb >> 16 & 0xffu), static_cast<std::uint8_t>(rrggbb >> 8 & 0xffu),
            static_cast<std::uint8_t>(rrggbb & 0xffu)};
  }

  bool operator==(const Color&) const = default;
};

// "#rrggbb"
std::string to_text(Color color);

// Reads "#rrggbb" or "rrggbb", in letters of either case.
std::optional<Color> parse_color(std::string_view text);

// The light of a channel, 0 to 1, by sRGB's transfer function.
double linear_light(std::uint8_t channel);

// A colour between two others, mixed as light is; share: 0 gives `from`, 1 gives `to`.
Color mixed(Color from, Color to, double share);

}  // namespace terrella
