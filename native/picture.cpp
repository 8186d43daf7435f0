#include "native/picture.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "app/develop.hpp"
#include "base/text.hpp"
#include "gl/caps.hpp"
#include "reference/picture.hpp"

namespace terrella {
namespace {

std::string big_endian(int number) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes += static_cast<char>(static_cast<unsigned>(number) >> shift & 0xffu);
  return bytes;
}

// By its signature, its size, and the chunk that ends every PNG.
bool is_whole_png(const StillOptions& still, std::string_view bytes) {
  constexpr std::string_view signature("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16), end("\0\0\0\0IEND\xae\x42\x60\x82", 12);
  return bytes.starts_with(text_of(signature, big_endian(still.width), big_endian(still.height))) &&
         bytes.ends_with(end);
}

}  // namespace

Image picture_by_gpu(Renderer& renderer, const PictureTask& task) {
  return task.pfm ? take_measurement(renderer, task.scene, task.still, task.channel)
                  : take_picture(renderer, task.scene, task.still);
}

std::string why_too_large(const PictureTask& task) {
  const int most = gl::caps().max_texture;
  if (!task.pfm || std::max(task.still.width, task.still.height) <= most) return {};
  return text_of("This machine measures pictures of at most ", most, " pixels along a side.");
}

Image picture_by_reference(const PictureTask& task, std::function<void(double)> progress) {
  reference::Options how;
  how.width = task.still.width;
  how.height = task.still.height;
  how.seconds = task.still.seconds;
  how.samples = task.still.samples;
  how.progress = std::move(progress);
  if (task.channel == Channel::color) {
    Image light = reference::light(task.scene, how);
    return task.pfm ? light : developed(light, task.scene.picture.tone);
  }
  reference::Geometry geometry = reference::geometry(task.scene, how);
  if (task.channel == Channel::distance) return geometry.distance;
  return task.channel == Channel::normal ? geometry.normal : geometry.height;
}

std::string encoded(const PictureTask& task, const Image& image) {
  return task.pfm ? encode_pfm(image) : encode_png(image);
}

bool is_whole(const PictureTask& task, const std::string& bytes) {
  if (!task.pfm) return is_whole_png(task.still, bytes);
  const int channels = task.channel == Channel::color || task.channel == Channel::normal ? 3 : 1;
  const Image blank(task.still.width, task.still.height, channels);
  const std::string like = encode_pfm(blank);
  const std::size_t header = like.size() - blank.pixels.size() * sizeof(float);
  return bytes.size() == like.size() && bytes.compare(0, header, like, 0, header) == 0;
}

}  // namespace terrella
