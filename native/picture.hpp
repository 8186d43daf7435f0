// One picture, as `terrella render` draws it.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <string_view>

#include "app/still.hpp"
#include "base/image.hpp"
#include "render/renderer.hpp"
#include "scene/scene.hpp"

namespace terrella {

// By the order of Channel.
inline constexpr std::array<std::string_view, 4> channel_names = {"color", "distance", "normal", "height"};

struct PictureTask {
  Scene scene;
  StillOptions still;
  Channel channel = Channel::color;
  bool pfm = false;  // else PNG, of Channel::color
};

// By the GPU. Needs what a Renderer needs.
Image picture_by_gpu(Renderer& renderer, const PictureTask& task);

// Empty, or why the current context cannot draw it.
std::string why_too_large(const PictureTask& task);

// By the reference. progress: as of reference::Options.
Image picture_by_reference(const PictureTask& task, std::function<void(double)> progress);

// The file's bytes.
std::string encoded(const PictureTask& task, const Image& image);

// Whether these are the bytes of such a picture, from the first to the last; what it shows is not looked at.
bool is_whole(const PictureTask& task, const std::string& bytes);

}  // namespace terrella
