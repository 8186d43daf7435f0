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

ImVec4 over(ImVec4 top, ImVec4 under) {
  const auto mixed = [&](float a, float b) { return a * top.w + b * (1.0F - top.w); };
  return {mixed(top.x, under.x), mixed(top.y, under.y), mixed(top.z, under.z), 1.0F};
}

ImVec4 over(ImVec4 top, float gray) { return over(top, ImVec4{gray, gray, gray, 1.0F}); }

// Every colour that text has, and all that it stands on.
struct Writing {
  ImGuiCol text;
  std::vector<ImGuiCol> grounds;
};

const std::vector<Writing>& writings() {
  static const std::vector<Writing> all{
      {ImGuiCol_Text,
       {ImGuiCol_WindowBg, ImGuiCol_PopupBg, ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive,
        ImGuiCol_Button, ImGuiCol_ButtonHovered, ImGuiCol_ButtonActive, ImGuiCol_Header, ImGuiCol_HeaderHovered,
        ImGuiCol_HeaderActive, ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive, ImGuiCol_TextSelectedBg}},
      // What matters less, and what stands in an empty search field.
      {ImGuiCol_TextDisabled,
       {ImGuiCol_WindowBg, ImGuiCol_PopupBg, ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive}},
      // Names of what differs from the preset, and what was chosen.
      {ImGuiCol_CheckMark, {ImGuiCol_WindowBg, ImGuiCol_PopupBg}},
  };
  return all;
}

TEST_F(PanelTest, TextIsLegible) {
  const ImVec4* colors = ImGui::GetStyle().Colors;
  for (const bool fingers : {false, true}) {
    style_panel(1.0F, fingers);
    for (const Writing& writing : writings()) {
      EXPECT_EQ(colors[writing.text].w, 1.0F) << ImGui::GetStyleColorName(writing.text);
      for (const ImGuiCol ground : writing.grounds) {
        for (const float window : {0.0F, 1.0F}) {  // what shows through it: space, clouds
          const ImVec4 under = over(colors[ImGuiCol_WindowBg], window);
          const bool window_itself = ground == ImGuiCol_WindowBg || ground == ImGuiCol_PopupBg;
          const ImVec4 stands_on = window_itself ? over(colors[ground], window) : over(colors[ground], under);
          EXPECT_GE(contrast(colors[writing.text], stands_on), text_contrast)
              << ImGui::GetStyleColorName(writing.text) << " on " << ImGui::GetStyleColorName(ground);
        }
      }
    }
  }
}

TEST_F(PanelTest, WhatHasTheKeyboardIsSeen) {
  const ImVec4* colors = ImGui::GetStyle().Colors;
  for (const ImGuiCol ground : {ImGuiCol_FrameBg, ImGuiCol_Button, ImGuiCol_Header, ImGuiCol_WindowBg}) {
    for (const float behind : {0.0F, 1.0F}) {
      EXPECT_GE(contrast(colors[ImGuiCol_NavHighlight], over(colors[ground], behind)), mark_contrast)
          << ImGui::GetStyleColorName(ground);
    }
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
  EXPECT_EQ(ImGui::GetIO().Fonts->ConfigData[0].SizePixels, 15.0F);
  style_panel(1.5F);
  EXPECT_EQ(ImGui::GetIO().Fonts->ConfigData[0].SizePixels, 23.0F);
}

TEST_F(PanelTest, TheFontHasWhatIsWritten) {
  const ImFont& font = *ImGui::GetIO().Fonts->Fonts[0];
  for (ImWchar letter = 0x20; letter <= 0xff; ++letter) {
    const bool is_control = letter >= 0x7f && letter <= 0x9f;
    EXPECT_EQ(font.FindGlyphNoFallback(letter) == nullptr, is_control) << letter;
  }
  EXPECT_NE(font.FindGlyphNoFallback(0x2026), nullptr);  // of texts that were shortened
}

// While a value is dragged, its text does not tremble.
TEST_F(PanelTest, FiguresAreOfOneWidth) {
  const ImFont& font = *ImGui::GetIO().Fonts->Fonts[0];
  for (ImWchar figure = '1'; figure <= '9'; ++figure) {
    EXPECT_EQ(font.GetCharAdvance(figure), font.GetCharAdvance('0')) << figure;
  }
}

TEST_F(PanelTest, RowsAreAsHighAsAHandNeeds) {
  click("terrain", 0.3F);
  const auto height = [&] { return place_of("terrain.height").bottom - place_of("terrain.height").top; };
  EXPECT_EQ(height(), 19.0F);
  style_panel(2.0F);
  unsigned char* pixels = nullptr;
  int columns = 0, rows = 0;
  ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &columns, &rows);
  frames(3);
  EXPECT_EQ(height(), 38.0F);
  style_panel(3.0F, true);
  ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &columns, &rows);
  frames(3);
  EXPECT_GE(height(), 3.0F * 44.0F);
}

}  // namespace
}  // namespace terrella
