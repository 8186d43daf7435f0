#include "panel/notices.hpp"

#include <imgui.h>

#include <algorithm>

#include "panel/widgets.hpp"

namespace terrella {
namespace {

void search_for(Search& search, const Parameter& parameter) {
  search.text = {};
  const std::size_t length = std::min(parameter.path.size(), search.text.size() - 1);
  std::copy_n(parameter.path.begin(), length, search.text.begin());
}

void link_to(Sheet& sheet, const Parameter* parameter) {
  if (parameter == nullptr) return;
  if (link_button(std::string(parameter->path).c_str())) search_for(sheet.memory.search, *parameter);
  sheet.place("notice/", parameter->path);
  tooltip("Shows this parameter.");
}

// id: one that stays while the numbers in the text change under a hand.
void show(Sheet& sheet, const std::string& text, int id) {
  const Notice notice = notice_of(text);
  ImGui::PushID(id);
  link_to(sheet, notice.about);
  ImGui::TextWrapped("%s", notice.sentence.c_str());
  link_to(sheet, notice.suggested);
  ImGui::PopID();
}

void dismiss_button(Sheet& sheet, float left, float size) {
  ImGui::SameLine(ImGui::GetCursorPosX() + left, 0.0F);
  if (ImGui::Button("x", {size, 0.0F})) sheet.wishes.dismiss_notices = true;
  sheet.place("dismiss");
  tooltip("Dismiss.");
}

}  // namespace

Notice notice_of(std::string_view text) {
  static constexpr std::string_view mark = ": ", question = "did you mean ";
  Notice notice;
  const std::size_t end = text.find(mark);
  if (end != std::string_view::npos) notice.about = find_parameter(text.substr(0, end));
  if (notice.about != nullptr) text.remove_prefix(end + mark.size());
  notice.sentence = text;
  const std::size_t asked = text.rfind(question);
  if (asked == std::string_view::npos || !text.ends_with('?')) return notice;
  text.remove_prefix(asked + question.size());
  text.remove_suffix(1);
  notice.suggested = find_parameter(text);
  return notice;
}

void notices_section(Sheet& sheet) {
  const auto &notices = sheet.facts.notices, &beyond = sheet.facts.beyond;
  if (notices.empty() && beyond.empty()) return;
  // The ground under the text is as high as the text, which is known only when it has been written.
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.ChannelsSplit(2);
  list.ChannelsSetCurrent(1);
  const ImVec2 from = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, margin = points(6.0F), button = ImGui::GetFrameHeight();
  ImGui::Dummy({0.0F, 0.0F});
  ImGui::Indent(margin);
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width - button - 3.0F * margin);
  ImGui::BeginGroup();
  int id = 0;
  for (const std::string& notice : notices) show(sheet, notice, id++);
  for (const std::string& sentence : beyond) show(sheet, sentence, id++);
  ImGui::EndGroup();
  ImGui::PopTextWrapPos();
  ImGui::Unindent(margin);
  if (!notices.empty()) dismiss_button(sheet, width - button - margin, button);
  const ImVec2 to{from.x + width, ImGui::GetCursorScreenPos().y};
  list.ChannelsSetCurrent(0);
  list.AddRectFilled(from, to, ImGui::GetColorU32(ImGuiCol_FrameBg), ImGui::GetStyle().FrameRounding);
  list.AddRect(from, to, ImGui::GetColorU32(ImGuiCol_Border), ImGui::GetStyle().FrameRounding);
  list.ChannelsMerge();
  ImGui::Spacing();
}

}  // namespace terrella
