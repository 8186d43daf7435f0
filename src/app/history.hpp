// Undo and redo: a scene's way so far, one step a gesture.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "scene/document.hpp"

namespace terrella {

// A scene at work, and how it was when it was opened.
struct Snapshot {
  SceneDocument document, opened;

  bool operator==(const Snapshot&) const = default;
};

class History {
 public:
  static constexpr std::size_t most_steps = 200;
  // Seconds of rest that end a run of notches, taps or calls.
  static constexpr double rest = 0.7;

  // What moves a value bit by bit, without a press and a release that tell where its gesture begins.
  enum class Means { wheel, keys, calls };

  // Starts with a scene to which nothing leads.
  void start(const Snapshot& first);

  // Goes on with another's way. past, future: the nearest last.
  void resume(std::vector<Snapshot> past, const Snapshot& present, std::vector<Snapshot> future);

  // A press, a file: the next change begins a step of its own.
  void begin();
  // A notch, a tap, a call. The next change goes on with the last step if that came by the same means, within `rest`,
  // and changed the same parameter; the camera counts as one, and so do several at once. now: seconds of any steady
  // clock.
  void go_on(Means means, double now);
  // The next change takes back what the last step did, if it leads to where that began, and leaves neither: the second
  // click of two.
  void take_back() { taking_back_ = true; }
  // The scene as it is after a change; nothing if it is what it was. Until the next begin or go_on all changes belong
  // together. What was undone is forgotten.
  void note(const Snapshot& snapshot, double now);

  [[nodiscard]] bool can_undo() const { return past_.size() > (last_step_is_empty() ? 1U : 0U); }
  [[nodiscard]] bool can_redo() const { return !future_.empty(); }
  // The nearest last.
  [[nodiscard]] const std::vector<Snapshot>& past() const { return past_; }
  [[nodiscard]] const std::vector<Snapshot>& future() const { return future_; }

  // One step back or ahead, and the scene there. Only if there is one.
  const Snapshot& undo();
  const Snapshot& redo();

 private:
  enum class Next { same, perhaps_new, sure_new };  // step to which the next change belongs

  // A hand that came back to where it began.
  bool last_step_is_empty() const { return !past_.empty() && past_.back() == present_; }
  void drop_empty_step();
  void step_from_present();
  // To the nearest of one side; the present becomes the nearest of the other.
  const Snapshot& go(std::vector<Snapshot>& to, std::vector<Snapshot>& from);

  std::vector<Snapshot> past_, future_;  // the nearest last
  Snapshot present_;
  Next next_ = Next::sure_new;
  Means means_ = Means::calls;
  bool taking_back_ = false;
  bool by_means_ = false;     // whether the last step, or the one to come, is of means_
  std::string_view subject_;  // of the last step: the one parameter that it changed, or the camera
  double last_ = 0.0;         // time of the last change, notch, tap or call
};

}  // namespace terrella
