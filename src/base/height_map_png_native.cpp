#include <png.h>

#include <bit>
#include <csetjmp>
#include <cstring>
#include <string>

#include "base/height_map.hpp"
#include "base/text.hpp"

namespace terrella {
namespace {

// A PNG as it is read, its samples as they stand in the file: heights are no light, and no gamma is theirs.
struct Png {
  std::string_view bytes;
  std::size_t at = 0;
  std::string error;
  std::string size_trouble;
  png_uint_32 width = 0, height = 0;
  int channels = 0;
  std::vector<std::uint16_t> row;
  std::vector<float> heights;
};

void take_bytes(png_structp reader, png_bytep to, std::size_t count) {
  Png& png = *static_cast<Png*>(png_get_io_ptr(reader));
  if (count > png.bytes.size() - png.at) png_error(reader, "it breaks off");
  std::memcpy(to, png.bytes.data() + png.at, count);
  png.at += count;
}

[[noreturn]] void note_error(png_structp reader, png_const_charp what) {
  static_cast<Png*>(png_get_error_ptr(reader))->error = what;
  png_longjmp(reader, 1);
}

void ignore_warning(png_structp, png_const_charp) {}

void take_row(Png& png) {
  const auto channels = static_cast<std::size_t>(png.channels);
  for (std::size_t x = 0; x < png.width; ++x) {
    const auto sample = [&](std::size_t channel) {
      return static_cast<float>(png.row[x * channels + channel]) / 65535.0F;
    };
    png.heights.push_back(channels < 3 ? sample(0) : luminance(sample(0), sample(1), sample(2)));
  }
}

// Not inlined into its caller, whose own objects must stay as they are when the library jumps.
[[gnu::noinline]] void read_rows(png_structp reader, png_infop info, std::string_view name, Png& png) {
  png_read_info(reader, info);
  png.width = png_get_image_width(reader, info);
  png.height = png_get_image_height(reader, info);
  png.size_trouble = trouble_with_size(name, png.width, png.height);
  if (!png.size_trouble.empty()) return;
  png_set_expand_16(reader);
  if constexpr (std::endian::native == std::endian::little) png_set_swap(reader);
  const int passes = png_set_interlace_handling(reader);
  png_read_update_info(reader, info);
  png.channels = png_get_channels(reader, info);
  const std::size_t row_bytes = png_get_rowbytes(reader, info);
  if (passes == 1) {
    png.row.resize(row_bytes / sizeof(std::uint16_t));
    for (png_uint_32 y = 0; y < png.height; ++y) {
      png_read_row(reader, reinterpret_cast<png_bytep>(png.row.data()), nullptr);
      take_row(png);
    }
    return;
  }
  png_error(reader, "it is interlaced, which is not read");
}

// Where the library finds something wrong it jumps back here: no object of this function may need to be destroyed.
void read_or_note(std::string_view name, Png& png) {
  png_structp reader = png_create_read_struct(PNG_LIBPNG_VER_STRING, &png, note_error, ignore_warning);
  png_infop info = png_create_info_struct(reader);
  if (setjmp(png_jmpbuf(reader)) == 0) {
    png_set_read_fn(reader, &png, take_bytes);
    read_rows(reader, info, name, png);
  }
  png_destroy_read_struct(&reader, &info, nullptr);
}

Result<SharedHeightMap> read_png_height_map(std::string_view name, std::string_view bytes) {
  Png png;
  png.bytes = bytes;
  read_or_note(name, png);
  if (!png.size_trouble.empty()) return Failure{png.size_trouble};
  if (!png.error.empty()) return Failure{text_of(shortened(name, 200), ": cannot be read as a PNG: ", png.error, ".")};
  return make_height_map(name, static_cast<int>(png.width), static_cast<int>(png.height), std::move(png.heights));
}

}  // namespace

Result<SharedHeightMap> read_height_map(std::string_view name, std::string_view bytes) {
  if (is_height_map(bytes))
    return bytes[0] == 'P' ? read_pfm_height_map(name, bytes) : read_png_height_map(name, bytes);
  return Failure{
      text_of(shortened(name, 200), ": is neither a PNG nor a portable float map (PFM), by its first bytes.")};
}

}  // namespace terrella
