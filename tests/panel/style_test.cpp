// Text is legible over whatever the planet shows: contrasts as WCAG 2.1 defines them, at least AA.
#include <cmath>

#include "hand.hpp"

namespace terrella {
namespace {

constexpr double text_contrast = 4.5, mark_contrast = 3.0;

double light(float channel) { return channel <= 0.04045F ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4); }

double luminance(ImVec4 c) { return 0.2126 * light(c.x) + 0.7152 * light(c.y) + 0.0722 * light(c.z); }

double contrast(ImVec4 a, ImVec4 b) {
  const double la = luminance(a), lb = luminance(b);
  return (std::max(la, lb) + 0.05) / (std::min(la, lb) + 0.05);
}

ImVec4 over(ImVec4 top, float behind) {
  const float rest = behind * (1.0F - top.w);
  return {top.x * top.w + rest, top.y * top.w + rest, top.z * top.w + rest, 1.0F};
}

TEST_F(PanelTest, TextIsLegible) {
  const ImVec4* colors = ImGui::GetStyle().Colors;
  for (const ImGuiCol text : {ImGuiCol_Text, ImGuiCol_TextDisabled, ImGuiCol_CheckMark}) {
    for (const ImGuiCol ground : {ImGuiCol_WindowBg, ImGuiCol_PopupBg}) {
      for (const float behind : {0.0F, 1.0F}) {
        EXPECT_GE(contrast(colors[text], over(colors[ground], behind)), text_contrast) << text << " on " << ground;
      }
    }
  }
  for (const ImGuiCol ground : {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_Button, ImGuiCol_ButtonHovered,
                                ImGuiCol_ButtonActive, ImGuiCol_Header, ImGuiCol_HeaderHovered, ImGuiCol_HeaderActive,
                                ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive, ImGuiCol_TextSelectedBg}) {
    EXPECT_GE(contrast(colors[ImGuiCol_Text], colors[ground]), text_contrast) << ground;
  }
}

TEST_F(PanelTest, MarksAreSeen) {
  const ImVec4* colors = ImGui::GetStyle().Colors;
  for (const ImGuiCol ground : {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_Header}) {
    EXPECT_GE(contrast(colors[ImGuiCol_CheckMark], colors[ground]), mark_contrast) << ground;  // a slider's line
  }
  EXPECT_GE(contrast(colors[ImGuiCol_Border], over(colors[ImGuiCol_WindowBg], 1.0F)), mark_contrast);
  EXPECT_GE(contrast(colors[ImGuiCol_Border], over(colors[ImGuiCol_WindowBg], 0.0F)), mark_contrast);
}

TEST_F(PanelTest, TheFontFitsTheScale) {
  EXPECT_EQ(ImGui::GetIO().Fonts->ConfigData[0].SizePixels, 13.0F);
  style_panel(1.5F);
  EXPECT_EQ(ImGui::GetIO().Fonts->ConfigData[0].SizePixels, 20.0F);
}

}  // namespace
}  // namespace terrella
