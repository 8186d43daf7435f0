#include "measure/subject.hpp"

#include <algorithm>

#include "app/still.hpp"
#include "gl/ledger.hpp"
#include "measure/counters.hpp"

namespace terrella {
namespace {

constexpr double between_frames = 1.0 / 60.0;  // s

// How many pixels are drawn for so many that are shown.
int drawn(int shown, const Scene& scene) {
  return std::max(1, static_cast<int>(shown * scene.quality.resolution_scale + 0.5));
}

}  // namespace

class Subject::Weighing {
 public:
  explicit Weighing(Subject& subject) : subject_(subject), before_(gl::ledger().bytes) {}
  ~Weighing() { subject_.held_ += gl::ledger().bytes - before_; }
  Weighing(const Weighing&) = delete;
  Weighing& operator=(const Weighing&) = delete;

 private:
  Subject& subject_;
  std::int64_t before_;
};

Subject::Subject(int width, int height)
    : width_(width), height_(height), screen_(width, height, gl::Format::rgba8, false) {}

Image Subject::pose(const Scene& scene) {
  const Weighing weighing(*this);
  scene_ = scene;
  seconds_ = 0.0;
  StillOptions options;
  options.width = width_;
  options.height = height_;
  return take_picture(renderer_, scene_, options);
}

DrawnGeometry Subject::geometry() {
  const Weighing weighing(*this);
  StillOptions options;
  options.width = drawn(width_, scene_);
  options.height = drawn(height_, scene_);
  return {take_measurement(renderer_, scene_, options, Channel::distance),
          take_measurement(renderer_, scene_, options, Channel::normal)};
}

double Subject::frame(Stopwatch& stopwatch) {
  const Weighing weighing(*this);
  View view;
  view.width = drawn(width_, scene_);
  view.height = drawn(height_, scene_);
  view.seconds = seconds_;
  view.scale = scene_.quality.resolution_scale;
  seconds_ += between_frames;
  return stopwatch.time([&] {
    renderer_.draw(scene_, view, {Channel::color, Effort::live, false});
    renderer_.show({screen_.framebuffer(), width_, height_}, scene_.quality.antialias);
  });
}

std::vector<double> Subject::work() const {
  RenderStats stats = renderer_.stats();
  stats.gpu_bytes = held_;
  return counted(stats);
}

}  // namespace terrella
