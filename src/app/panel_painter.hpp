// Draws what the panel shows: as a picture, which is made anew only when that has changed. Without a graphics card the
// panel's thousands of small triangles would cost every frame a third more.
#pragma once

#include <memory>
#include <vector>

#include "gl/late_program.hpp"
#include "gl/mesh.hpp"
#include "gl/target.hpp"

struct ImDrawData;

namespace terrella {

class PanelPainter {
 public:
  // Needs a current context and Dear ImGui's. At most one lives at a time.
  PanelPainter();
  ~PanelPainter();
  PanelPainter(const PanelPainter&) = delete;
  PanelPainter& operator=(const PanelPainter&) = delete;

  // Before a frame of Dear ImGui.
  void begin_frame();

  // The font has another size: it is made anew when next drawn.
  void forget_font();

  // What textures hold that the panel shows has changed, though not their names.
  void textures_changed() { last_.clear(); }

  // Lays what the last frame of Dear ImGui shows over a screen.
  void draw(ImDrawData& shown, const gl::Screen& screen);

 private:
  // Everything that tells what is seen, in one row of bytes.
  static std::vector<unsigned char> bytes_of(const ImDrawData& shown);
  void take_picture(ImDrawData& shown);
  void lay_over(const gl::Screen& screen);

  bool fresh_ = true;                // what is shown may have changed
  std::vector<unsigned char> last_;  // bytes_of what was drawn last
  gl::Pixels box_;                   // that the picture shows, from the bottom left of the screen
  std::unique_ptr<gl::Target> picture_;
  gl::LateProgram overlay_{"picture/overlay", "picture/screen"};
  gl::FullScreen triangle_;
};

}  // namespace terrella
