#include "app/history.hpp"

#include <utility>

#include "base/check.hpp"
#include "scene/parameters.hpp"

namespace terrella {
namespace {

constexpr std::string_view camera = "camera", many = "";

// The one parameter in which two scenes differ; the camera's count as one.
std::string_view subject_of(const SceneDocument& a, const SceneDocument& b) {
  if (a.preset != b.preset) return many;
  std::string_view subject = many;
  for (const Parameter& parameter : parameters()) {
    if (parameter.get(a.scene) == parameter.get(b.scene)) continue;
    const std::string_view changed = parameter.group == camera ? camera : parameter.path;
    if (subject != many && subject != changed) return many;
    subject = changed;
  }
  return subject;
}

}  // namespace

void History::start(const Snapshot& first) {
  *this = {};
  present_ = first;
}

void History::resume(std::vector<Snapshot> past, const Snapshot& present, std::vector<Snapshot> future) {
  start(present);
  past_ = std::move(past);
  future_ = std::move(future);
}

void History::begin() {
  next_ = Next::sure_new;
  by_means_ = false;
  taking_back_ = false;
}

void History::go_on(Means means, double now) {
  const bool may_go_on = by_means_ && means == means_ && now - last_ <= rest;
  if (!may_go_on) {
    next_ = Next::sure_new;
  } else if (next_ == Next::same) {
    next_ = Next::perhaps_new;
  }
  means_ = means;
  by_means_ = true;
  last_ = now;
}

void History::note(const Snapshot& snapshot, double now) {
  if (snapshot == present_) return;
  const std::string_view subject = next_ == Next::same ? subject_ : subject_of(present_.document, snapshot.document);
  const bool goes_on = next_ == Next::same || (next_ == Next::perhaps_new && subject == subject_);
  const bool leads_back = !goes_on && !past_.empty() && past_.back() == snapshot && taking_back_;
  if (!goes_on && !leads_back) step_from_present();
  present_ = snapshot;
  if (leads_back) past_.pop_back();
  next_ = leads_back ? Next::sure_new : Next::same;
  taking_back_ = false;
  subject_ = subject;
  last_ = now;
  future_.clear();
}

void History::step_from_present() {
  drop_empty_step();
  past_.push_back(present_);
  if (past_.size() > most_steps) past_.erase(past_.begin());
}

void History::drop_empty_step() {
  if (last_step_is_empty()) past_.pop_back();
}

const Snapshot& History::undo() {
  CHECK(can_undo(), "nothing to undo");
  drop_empty_step();
  return go(past_, future_);
}

const Snapshot& History::redo() {
  CHECK(can_redo(), "nothing to redo");
  drop_empty_step();
  return go(future_, past_);
}

const Snapshot& History::go(std::vector<Snapshot>& to, std::vector<Snapshot>& from) {
  from.push_back(present_);
  present_ = to.back();
  to.pop_back();
  begin();
  return present_;
}

}  // namespace terrella
