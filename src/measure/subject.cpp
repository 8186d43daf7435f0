#include "measure/subject.hpp"

#include <algorithm>

#include "app/still.hpp"
#include "gl/caps.hpp"
#include "gl/ledger.hpp"
#include "measure/counters.hpp"
#include "measure/moment.hpp"

namespace terrella {
namespace {

// Pixels along a side for each one shown, of measurements: the reference's take long, and more show nothing new.
constexpr double largest_measured = 2.0;
constexpr double between_frames = 1.0 / 60.0;  // s

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
    : width_(width), height_(height), screen_(width, height, gl::Format::rgba8, gl::Depth::none) {}

Image Subject::pose(const Scene& scene) {
  const Weighing weighing(*this);
  scene_ = scene;
  seconds_ = judged_at(scene);
  StillOptions options;
  options.width = width_;
  options.height = height_;
  options.seconds = seconds_;
  return take_picture(renderer_, scene_, options);
}

DrawnGeometry Subject::geometry() {
  const Weighing weighing(*this);
  StillOptions options;
  const View drawn = view(largest_measured);
  options.width = drawn.width;
  options.height = drawn.height;
  options.seconds = seconds_;
  return {take_measurement(renderer_, scene_, options, Channel::distance),
          take_measurement(renderer_, scene_, options, Channel::normal)};
}

View Subject::view(double largest) const {
  View shown;
  shown.width = width_;
  shown.height = height_;
  shown.seconds = seconds_;
  return drawn_at(shown, std::min(scene_.quality.resolution_scale, largest), gl::caps().max_texture);
}

double Subject::frame(Stopwatch& stopwatch) {
  const Weighing weighing(*this);
  const View drawn = view();
  seconds_ += between_frames;
  return stopwatch.time([&] {
    renderer_.draw(scene_, drawn, {Channel::color, Effort::live, false});
    renderer_.show({screen_.framebuffer(), width_, height_}, scene_.quality.antialias);
  });
}

std::vector<double> Subject::work() const {
  RenderStats stats = renderer_.stats();
  stats.gpu_bytes = held_;
  return counted(stats);
}

}  // namespace terrella
