#include "panel/facts_view.hpp"

#include <imgui.h>

#include <cmath>

#include "base/text.hpp"
#include "panel/quantity.hpp"
#include "panel/sections.hpp"
#include "panel/widgets.hpp"

namespace terrella {
namespace {

// "1 234 567"
std::string grouped(std::int64_t number) {
  std::string digits = text_of(number);
  for (std::size_t end = digits.size(); end > 3; end -= 3) {
    if (digits[end - 4] != '-') digits.insert(end - 3, 1, ' ');
  }
  return digits;
}

void fact(const char* name, const std::string& value) {
  two_columns(
      0.35F, [&] { quiet_text(name); }, [&] { ImGui::TextWrapped("%s", value.c_str()); });
}

std::string one_decimal(double value) { return short_number(std::round(value * 10.0) / 10.0); }

}  // namespace

void decisions_section(const Sheet& sheet) {
  if (!section_header(sheet, decisions_name, "What is modelled")) return;
  for (const PanelFacts::Decision& decision : sheet.facts.decisions) {
    const auto chosen = [&] {
      ImGui::TextWrapped("%s", decision.what.c_str());
      ImGui::TextColored(ImGui::GetStyleColorVec4(ImGuiCol_CheckMark), "%s", decision.chosen.c_str());
    };
    two_columns(0.42F, chosen, [&] { quiet_text(decision.why); });
    ImGui::Separator();
  }
}

void statistics_section(const Sheet& sheet) {
  if (!section_header(sheet, statistics_name, "Statistics")) return;
  const PanelFacts& facts = sheet.facts;
  if (facts.frame_ms > 0.0) {
    fact("Frame", text_of(one_decimal(facts.frame_ms), " ms, ", one_decimal(1000.0 / facts.frame_ms), " fps"));
  } else {
    fact("Frame", "at rest");
  }
  fact("Triangles", grouped(facts.triangles));
  fact("Draw calls", grouped(facts.draw_calls));
  fact("GPU memory", text_of(one_decimal(static_cast<double>(facts.gpu_bytes) * 1e-6), " MB"));
  fact("Noise a frame", grouped(facts.noise_evaluations));
  fact("Renderer", facts.renderer);
}

}  // namespace terrella
