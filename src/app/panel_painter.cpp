#include "app/panel_painter.hpp"

#include <imgui.h>
#include <imgui_impl_opengl3.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>
#include <utility>

#include "gl/caps.hpp"

namespace terrella {
namespace {

template <class T>
void append(std::vector<unsigned char>& bytes, std::span<const T> values) {
  const std::size_t before = bytes.size();
  bytes.resize(before + values.size_bytes());
  if (!values.empty()) std::memcpy(bytes.data() + before, values.data(), values.size_bytes());
}

// The pixels that hold all that is shown.
gl::Pixels box_of(const ImDrawData& shown) {
  ImVec2 least = shown.DisplaySize, most(0.0F, 0.0F);
  for (const ImDrawList* list : shown.CmdLists) {
    for (const ImDrawVert& vertex : list->VtxBuffer) {
      least = {std::min(least.x, vertex.pos.x), std::min(least.y, vertex.pos.y)};
      most = {std::max(most.x, vertex.pos.x), std::max(most.y, vertex.pos.y)};
    }
  }
  const auto whole = [](float value, float end) { return static_cast<int>(std::clamp(value, 0.0F, end)); };
  const int left = whole(std::floor(least.x), shown.DisplaySize.x),
            top = whole(std::floor(least.y), shown.DisplaySize.y);
  const int right = whole(std::ceil(most.x), shown.DisplaySize.x),
            bottom = whole(std::ceil(most.y), shown.DisplaySize.y);
  return {left, static_cast<int>(shown.DisplaySize.y) - bottom, right - left, bottom - top};
}

}  // namespace

PanelPainter::PanelPainter() { ImGui_ImplOpenGL3_Init(gl::caps().es ? "#version 300 es" : "#version 330 core"); }

PanelPainter::~PanelPainter() { ImGui_ImplOpenGL3_Shutdown(); }

void PanelPainter::begin_frame() {
  ImGui_ImplOpenGL3_NewFrame();
  fresh_ = true;
}

void PanelPainter::forget_font() {
  ImGui_ImplOpenGL3_DestroyDeviceObjects();
  last_.clear();
  fresh_ = true;
}

void PanelPainter::draw(ImDrawData& shown, const gl::Screen& screen) {
  if (!overlay_.ready(false)) {
    screen.begin();
    ImGui_ImplOpenGL3_RenderDrawData(&shown);
    return;
  }
  if (std::exchange(fresh_, false)) {
    std::vector<unsigned char> bytes = bytes_of(shown);
    if (bytes != last_) {
      last_ = std::move(bytes);
      take_picture(shown);
    }
  }
  if (picture_) lay_over(screen);
}

std::vector<unsigned char> PanelPainter::bytes_of(const ImDrawData& shown) {
  std::vector<unsigned char> bytes;
  append(bytes, std::span(&shown.DisplaySize, 1));
  for (const ImDrawList* list : shown.CmdLists) {
    append(bytes, std::span<const ImDrawVert>(list->VtxBuffer.begin(), list->VtxBuffer.end()));
    append(bytes, std::span<const ImDrawIdx>(list->IdxBuffer.begin(), list->IdxBuffer.end()));
    for (const ImDrawCmd& command : list->CmdBuffer) {
      append(bytes, std::span(&command.ClipRect, 1));
      append(bytes, std::span(&command.TextureId, 1));
      append(bytes, std::span(&command.ElemCount, 1));
    }
  }
  return bytes;
}

void PanelPainter::take_picture(ImDrawData& shown) {
  box_ = box_of(shown);
  if (box_.width <= 0 || box_.height <= 0) return picture_.reset();
  if (!picture_ || picture_->image().width() != box_.width || picture_->image().height() != box_.height) {
    picture_.reset();
    picture_ = std::make_unique<gl::Target>(box_.width, box_.height, gl::Format::rgba8, gl::Depth::none);
  }
  picture_->begin();
  constexpr float clear[] = {0.0F, 0.0F, 0.0F, 0.0F};
  glClearBufferfv(GL_COLOR, 0, clear);
  const ImVec2 place = shown.DisplayPos, size = shown.DisplaySize;
  shown.DisplayPos = {static_cast<float>(box_.left), size.y - static_cast<float>(box_.bottom + box_.height)};
  shown.DisplaySize = {static_cast<float>(box_.width), static_cast<float>(box_.height)};
  ImGui_ImplOpenGL3_RenderDrawData(&shown);
  shown.DisplayPos = place;
  shown.DisplaySize = size;
}

// The picture's colours come weighted by their opacity, as Dear ImGui's blending leaves them on an empty picture.
void PanelPainter::lay_over(const gl::Screen& screen) {
  screen.begin();
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  const gl::Scissors scissors(box_);
  picture_->image().bind(gl::unit_image);
  overlay_->use();
  overlay_->set("corner", static_cast<float>(box_.left), static_cast<float>(box_.bottom));
  triangle_.draw();
  glDisable(GL_BLEND);
}

}  // namespace terrella
