// A session that goes on in another program.
#include <imgui.h>

#include <utility>

#include "app/session.hpp"
#include "base/named_lines.hpp"
#include "scene/json.hpp"

namespace terrella {
namespace {

constexpr int frames_to_settle = 6;  // until the panel is scrolled as it was

CameraMode mode_of(double number) {
  for (const CameraModeText& text : camera_mode_texts) {
    if (static_cast<int>(text.mode) == static_cast<int>(number)) return text.mode;
  }
  return CameraMode::orbit;
}

}  // namespace

SceneDocument Session::document_of(std::string_view json) const {
  SceneDocument document;
  terrella::load_json(document, json);
  find_map(document.scene);
  return document;
}

bool Session::hands_rest() const {
  const bool on_panel = ImGui::IsAnyMouseDown() || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
  if (panel_shown_ && (on_panel || wants_text() || typed_ahead_)) return false;
  return !hand_is_busy() && keys_down_.empty() && !camera_.moving();
}

std::string Session::hand_over() const {
  NamedLines lines;
  const auto add = [&](std::string_view name, const SceneDocument& document, const SceneDocument& opened) {
    lines.add("opened", to_json(opened));
    lines.add(name, to_json(document));
  };
  for (const Snapshot& snapshot : history_.past()) add("past", snapshot.document, snapshot.opened);
  for (const Snapshot& snapshot : history_.future()) add("future", snapshot.document, snapshot.opened);
  add("present", document_, opened_);
  lines.add("camera_mode", static_cast<int>(camera_.mode()));
  lines.add("seconds", seconds_);
  lines.add("paused", paused_);
  lines.add("panel_shown", panel_shown_);
  lines.add("planet_shown", planet_shown_);
  for (const std::string& notice : notices_) lines.add("notice", notice);
  panel_.add_state(lines);
  return lines.text();
}

// Names that are not known are passed over: the programs may be of different versions.
void Session::take_over(const std::string& text) {
  std::vector<Snapshot> past, future;
  SceneDocument opened;
  for (const NamedLine& line : lines_of(text)) {
    if (line.name == "opened") opened = document_of(line.words);
    if (line.name == "past") past.push_back({document_of(line.words), opened});
    if (line.name == "future") future.push_back({document_of(line.words), opened});
    if (line.name == "present") {
      document_ = document_of(line.words);
      opened_ = opened;
    }
    if (line.name == "camera_mode") camera_.set_mode(mode_of(line.number()));
    if (line.name == "seconds") seconds_ = line.number();
    if (line.name == "paused") paused_ = line.number() != 0.0;
    if (line.name == "panel_shown") panel_shown_ = line.number() != 0.0;
    if (line.name == "planet_shown") planet_shown_ = line.number() != 0.0;
    if (line.name == "notice") notices_.emplace_back(line.words);
  }
  history_.resume(std::move(past), {document_, opened_}, std::move(future));
  panel_.take_state(text);
  kept_habits_ = panel_.habits();
  planet_stale_ = true;
  panel_frames_ = frames_to_settle;
}

}  // namespace terrella
