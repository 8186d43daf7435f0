// How the panel looks: dark, quiet, and legible over whatever the planet shows behind it.
#include <imgui.h>

#include <cmath>
#include <span>

#include "panel/font_bytes.hpp"
#include "panel/panel.hpp"
#include "panel/widgets.hpp"

namespace terrella {
namespace {

constexpr float finger_font = 17.3F;    // points; a phone is small, and nearer to the eye than a desk's screen
constexpr float finger_height = 44.0F;  // points, of whatever a finger shall hit

// What lies under text, lies nearly opaque: contrast holds over white clouds and black space alike.
constexpr float window_opacity = 0.9F;

ImVec4 rgb(unsigned hex, float opacity = 1.0F) {
  const auto channel = [&](unsigned shift) { return static_cast<float>(hex >> shift & 0xffu) / 255.0F; };
  return {channel(16), channel(8), channel(0), opacity};
}

void set_colors(ImVec4* colors) {
  const ImVec4 ground = rgb(0x12161c), field = rgb(0x242d38), field_lit = rgb(0x2f3b49), fill = rgb(0x2c5f92),
               fill_lit = rgb(0x34689b), line = rgb(0x6f7f8f), accent = rgb(0x7cc0ff);
  colors[ImGuiCol_Text] = rgb(0xe8edf2);
  colors[ImGuiCol_TextDisabled] = rgb(0xb0bcc8);
  colors[ImGuiCol_TextSelectedBg] = fill;
  colors[ImGuiCol_WindowBg] = {ground.x, ground.y, ground.z, window_opacity};
  colors[ImGuiCol_PopupBg] = {ground.x, ground.y, ground.z, 0.97F};
  colors[ImGuiCol_Border] = line;
  colors[ImGuiCol_FrameBg] = field;
  colors[ImGuiCol_FrameBgHovered] = colors[ImGuiCol_FrameBgActive] = field_lit;
  colors[ImGuiCol_CheckMark] = accent;
  colors[ImGuiCol_NavHighlight] = accent;
  colors[ImGuiCol_SliderGrab] = fill;
  colors[ImGuiCol_SliderGrabActive] = fill_lit;
  colors[ImGuiCol_Button] = rgb(0x2b3744);
  colors[ImGuiCol_ButtonHovered] = rgb(0x394959);
  colors[ImGuiCol_ButtonActive] = fill;
  colors[ImGuiCol_Header] = rgb(0x1d252e);
  colors[ImGuiCol_HeaderHovered] = field_lit;
  colors[ImGuiCol_HeaderActive] = fill;
  colors[ImGuiCol_ScrollbarBg] = rgb(0x000000, 0.0F);
  colors[ImGuiCol_ScrollbarGrab] = rgb(0x5b6a79);
  colors[ImGuiCol_ScrollbarGrabHovered] = colors[ImGuiCol_ScrollbarGrabActive] = rgb(0x7b8b9b);
  colors[ImGuiCol_TableBorderStrong] = colors[ImGuiCol_TableBorderLight] = line;
}

// Small letters are finer than pixels: between these they lie where their gaps are even, and lit more, as what covers
// half a pixel looks like less than half. Large ones are sharp only at whole pixels.
void set_font(float height) {
  constexpr float large = 30.0F;  // pixels
  constexpr float more_light = 1.3F;
  static constexpr ImWchar letters[] = {0x20, 0xff, 0x2026, 0x2026, 0};
  const std::span<const unsigned char> bytes = font_bytes();
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;  // it takes a copy
  config.PixelSnapH = height >= large;
  config.OversampleH = config.PixelSnapH ? 1 : 2;
  config.OversampleV = 1;
  config.RasterizerMultiply = config.PixelSnapH ? 1.0F : more_light;
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  fonts.Clear();
  fonts.AddFontFromMemoryTTF(const_cast<unsigned char*>(bytes.data()), static_cast<int>(bytes.size()), height, &config,
                             letters);
}

}  // namespace

void style_panel(float scale, bool fingers) {
  ImGuiStyle style;
  ImGui::StyleColorsDark(&style);
  set_colors(style.Colors);
  style.WindowPadding = {10.0F, 10.0F};
  style.FramePadding = {6.0F, 2.0F};
  style.ItemSpacing = {6.0F, 4.0F};
  style.ItemInnerSpacing = {4.0F, 4.0F};
  style.CellPadding = {6.0F, 4.0F};
  style.WindowRounding = 6.0F;
  style.PopupRounding = 4.0F;
  style.FrameRounding = 3.0F;
  style.ScrollbarSize = 11.0F;
  style.ScrollbarRounding = 6.0F;
  style.WindowBorderSize = 0.0F;
  style.PopupBorderSize = 1.0F;
  style.SeparatorTextBorderSize = 1.0F;
  style.SelectableTextAlign = {0.0F, 0.5F};
  style.DisabledAlpha = 0.55F;
  if (fingers) style.ScrollbarSize = 6.0F;  // it only shows where one is: fingers scroll by the rows
  style.ScaleAllSizes(scale);
  const float font = std::round((fingers ? finger_font : kFontSize) * scale);
  // Not before: scaling cuts to whole pixels.
  if (fingers) style.FramePadding.y = std::ceil(0.5F * (finger_height * scale - font));
  // The session draws only what has changed: a tooltip that waits would never come.
  style.HoverDelayShort = style.HoverDelayNormal = style.HoverStationaryDelay = 0.0F;
  ImGui::GetStyle() = style;
  set_font(font);
}

}  // namespace terrella
