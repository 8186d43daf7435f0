#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <optional>

#include "base/height_map.hpp"
#include "base/text.hpp"

namespace terrella {

bool is_height_map(std::string_view bytes) {
  return bytes.starts_with("\x89PNG") || bytes.starts_with("Pf") || bytes.starts_with("PF");
}

float luminance(float red, float green, float blue) { return 0.2126F * red + 0.7152F * green + 0.0722F * blue; }

namespace {

// The header's words, one after the other; each ends with a single character of space.
class Words {
 public:
  explicit Words(std::string_view bytes) : bytes_(bytes) {}

  std::string_view next() {
    constexpr std::string_view kSpaces = " \t\r\n";
    const std::size_t from = std::min(bytes_.find_first_not_of(kSpaces, at_), bytes_.size());
    const std::size_t to = std::min(bytes_.find_first_of(kSpaces, from), bytes_.size());
    at_ = std::min(to + 1, bytes_.size());
    return bytes_.substr(from, to - from);
  }
  [[nodiscard]] std::string_view rest() const { return bytes_.substr(at_); }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

template <class Number>
std::optional<Number> number_in(std::string_view word) {
  Number number{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return number;
}

float float_at(std::string_view bytes, std::size_t at, bool big_endian) {
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::uint32_t byte = static_cast<unsigned char>(bytes[at + i]);
    bits |= byte << 8U * (big_endian ? 3 - i : i);
  }
  float value = 0.0F;
  std::memcpy(&value, &bits, sizeof value);  // std::bit_cast is missing where Emscripten is Debian's
  return value;
}

}  // namespace

Result<SharedHeightMap> read_pixels_of_height_map(std::string_view name, int width, int height,
                                                  const unsigned char* rgba) {
  if (std::string trouble = trouble_with_size(name, width, height); !trouble.empty()) return Failure{trouble};
  std::vector<float> heights(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (float& to : heights) {
    to = luminance(rgba[0], rgba[1], rgba[2]) / 255.0F;
    rgba += 4;
  }
  return make_height_map(name, width, height, std::move(heights));
}

Result<SharedHeightMap> read_pfm_height_map(std::string_view name, std::string_view bytes) {
  const auto failure = [&](const auto&... what) { return Failure{text_of(shortened(name, 200), ": ", what...)}; };
  Words words(bytes);
  const std::size_t channels = words.next() == "PF" ? 3 : 1;
  const auto width = number_in<int>(words.next()), height = number_in<int>(words.next());
  const std::string_view scale = words.next();
  if (!width || !height || scale.empty()) {
    return failure("is no portable float map: after Pf or PF its width, its height and a scale should stand.");
  }
  if (std::string trouble = trouble_with_size(name, *width, *height); !trouble.empty()) return Failure{trouble};
  const auto columns = static_cast<std::size_t>(*width), rows = static_cast<std::size_t>(*height);
  const std::size_t due = columns * rows * channels * sizeof(float);
  if (words.rest().size() < due) {
    return failure("breaks off: ", *width, "x", *height, " pixels take ", due, " bytes, and there are ",
                   words.rest().size(), ".");
  }
  std::vector<float> heights(columns * rows);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    // Rows stand from the bottom up.
    const std::size_t from = ((rows - 1 - i / columns) * columns + i % columns) * channels;
    const auto sample = [&](std::size_t channel) {
      return float_at(words.rest(), (from + channel) * sizeof(float), !scale.starts_with('-'));
    };
    heights[i] = channels == 1 ? sample(0) : luminance(sample(0), sample(1), sample(2));
  }
  return make_height_map(name, *width, *height, std::move(heights));
}

}  // namespace terrella
