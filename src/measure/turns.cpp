#include "measure/turns.hpp"

#include <memory>
#include <numeric>
#include <random>
#include <utility>

#include "measure/control_load.hpp"
#include "measure/subject.hpp"
#include "measure/thumbnail.hpp"

namespace terrella {
namespace {

// Timed, after one that is not: the renderer before it leaves its own things in caches.
constexpr int frames_a_turn = 2;

class TurnTable {
 public:
  TurnTable(const TradePlan& plan, std::size_t scenes) {
    for (std::size_t i = 0; i < scenes; ++i) subjects_.push_back(std::make_unique<Subject>(plan.width, plan.height));
  }

  [[nodiscard]] bool of_the_gpu() const { return stopwatch_.of_the_gpu(); }
  [[nodiscard]] const std::vector<double>& control_ms() const { return control_ms_; }

  Sighting look_at(std::size_t i, const Scene& scene, Truth& truth) {
    const Image picture = subjects_[i]->pose(scene);
    const Judgement judged = judge(picture, subjects_[i]->geometry(), truth);
    // Once more: measurements are drawn to other targets, and the first frame after them makes those of light anew.
    subjects_[i]->pose(scene);
    subjects_[i]->frame(stopwatch_);
    return {{}, {}, {}, judged.error, thumbnail(picture), thumbnail(judged.flip)};
  }

  // beside: is timed first or last.
  void time(std::size_t i, std::optional<std::size_t> beside, bool last, Sighting& sighting) {
    if (beside && !last) time(*beside, sighting.beside);
    time(i, sighting.times);
    sighting.work = subjects_[i]->work();
    if (beside && last) time(*beside, sighting.beside);
  }

  void time_control() {
    for (int i = 0; i <= frames_a_turn; ++i) {
      const double ms = stopwatch_.time([&] { control_.draw(); });
      if (i > 0) control_ms_.push_back(ms);
    }
  }

 private:
  void time(std::size_t i, std::vector<double>& times) {
    subjects_[i]->frame(stopwatch_);
    for (int frame = 0; frame < frames_a_turn; ++frame) times.push_back(subjects_[i]->frame(stopwatch_));
  }

  Stopwatch stopwatch_;
  ControlLoad control_;
  std::vector<double> control_ms_;
  std::vector<std::unique_ptr<Subject>> subjects_;
};

// In another order each round, so that nobody always follows the same one; the same on every machine.
std::vector<std::size_t> order_of(std::size_t round, std::size_t count) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937 random(static_cast<unsigned>(round));
  for (std::size_t left = count; left > 1; --left) std::swap(order[left - 1], order[random() % left]);
  return order;
}

}  // namespace

Turns take_turns(const std::vector<Timed>& scenes, const std::vector<Viewpoint>& cameras, std::vector<Truth>& truths,
                 const TradePlan& plan, const std::function<void(double part)>& progress) {
  const std::size_t count = scenes.size(), rounds = static_cast<std::size_t>(plan.rounds);
  Turns turns;
  turns.sightings.resize(count);
  TurnTable table(plan, count);
  const double all = static_cast<double>(cameras.size() * count * (rounds + 4));
  double done = 0.0;
  for (std::size_t c = 0; c < cameras.size(); ++c) {
    for (std::size_t i = 0; i < count; ++i) {
      turns.sightings[i].push_back(table.look_at(i, seen_by(scenes[i].scene, cameras[c]), truths[c]));
      progress((done += 4.0) / all);
    }
    for (std::size_t round = 0; round < rounds; ++round) {
      table.time_control();
      for (const std::size_t i : order_of(round, count)) {
        table.time(i, scenes[i].beside, round % 2 == 1, turns.sightings[i].back());
        progress((done += 1.0) / all);
      }
    }
  }
  turns.control_ms = table.control_ms();
  turns.gpu_timer = table.of_the_gpu();
  return turns;
}

}  // namespace terrella
