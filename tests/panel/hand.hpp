// A panel without a window, and a hand that clicks, drags and types in it.
#pragma once

#include <gtest/gtest.h>
#include <imgui.h>

#include <string>
#include <vector>

#include "panel/panel.hpp"
#include "scene/parameters.hpp"

namespace terrella {

class PanelTest : public testing::Test {
 protected:
  // So tall that all groups are in sight when open.
  PanelTest() : PanelTest(1280.0F, 6000.0F) {}

  PanelTest(float width, float height) : context_(ImGui::CreateContext()) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    io.DisplaySize = {width, height};
    io.DeltaTime = 1.0F / 60.0F;
    style_panel(1.0F);
    unsigned char* pixels = nullptr;
    int columns = 0, rows = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &columns, &rows);
    frames(3);
  }

  ~PanelTest() override { ImGui::DestroyContext(context_); }

  PanelWishes frame() {
    places.clear();
    ImGui::NewFrame();
    const PanelWishes wishes = panel.draw(document, facts, &places);
    ImGui::Render();
    return wishes;
  }

  void frames(int count) {
    for (int i = 0; i < count; ++i) frame();
  }

  int count_of(std::string_view name) const {
    int count = 0;
    for (const WidgetPlace& place : places) count += place.name == name ? 1 : 0;
    return count;
  }

  // Of the widget as it was drawn last.
  WidgetPlace place_of(const std::string& name) const {
    for (const WidgetPlace& place : places) {
      if (place.name == name) return place;
    }
    ADD_FAILURE() << "no widget " << name;
    return {name, 0.0F, 0.0F, 0.0F, 0.0F};
  }

  // To a share of its width; beyond 0..1 is beside it.
  void point_at(const std::string& name, float share = 0.5F) {
    const WidgetPlace place = place_of(name);
    ImGui::GetIO().AddMousePosEvent(place.left + share * (place.right - place.left), (place.top + place.bottom) * 0.5F);
    frame();
  }

  // What the user wishes in the frame where the button goes down or up.
  PanelWishes press() { return button(true); }
  PanelWishes release() { return button(false); }

  // The first wish that comes of it.
  PanelWishes click(const std::string& name, float share = 0.5F) {
    point_at(name, share);
    const PanelWishes pressed = press();
    const PanelWishes released = release();
    frames(2);
    return pressed == PanelWishes{} ? released : pressed;
  }

  void drag(const std::string& name, float from, float to) {
    point_at(name, from);
    press();
    point_at(name, to);
    release();
    frame();
  }

  void type(const std::string& text) {
    ImGui::GetIO().AddInputCharactersUTF8(text.c_str());
    frames(2);
  }

  void tap(ImGuiKey key) {
    ImGui::GetIO().AddKeyEvent(key, true);
    frame();
    ImGui::GetIO().AddKeyEvent(key, false);
    frames(2);
  }

  // Ctrl+click, a text, a key.
  void type_into(const std::string& name, const std::string& text, ImGuiKey last = ImGuiKey_Enter) {
    ImGui::GetIO().AddKeyEvent(ImGuiMod_Ctrl, true);
    click(name);
    ImGui::GetIO().AddKeyEvent(ImGuiMod_Ctrl, false);
    frames(2);
    type(text);
    tap(last);
  }

  void open_all_groups() {
    for (const Group& group : groups()) click(std::string(group.name), 0.3F);
    ImGui::GetIO().AddMousePosEvent(1200.0F, 5900.0F);
    frame();
  }

  SceneDocument document;
  PanelFacts facts;
  std::vector<WidgetPlace> places;  // of the last frame

  Panel panel;

 private:
  PanelWishes button(bool down) {
    ImGui::GetIO().AddMouseButtonEvent(0, down);
    return frame();
  }

  ImGuiContext* context_;
};

}  // namespace terrella
