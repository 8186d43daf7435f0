// Draws a scene. Everything it holds is rebuilt from the scene, so that a lost context costs only time: make a new one.
#pragma once

#include <bitset>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gl/uniform_buffer.hpp"
#include "passes/air_fresnel.hpp"
#include "passes/clouds_shell.hpp"
#include "passes/frame.hpp"
#include "passes/ground.hpp"
#include "passes/land_mirror.hpp"
#include "passes/light_fade.hpp"
#include "passes/night_lights.hpp"
#include "passes/picture.hpp"
#include "passes/rings_plane.hpp"
#include "passes/sea.hpp"
#include "passes/stars_noise.hpp"
#include "passes/sun_disc.hpp"
#include "passes/water_backdrop.hpp"
#include "render/slot.hpp"

namespace terrella {

// What a picture is to be, beside scene and view.
struct Shot {
  Channel channel = Channel::color;
  Effort effort = Effort::complete;
  bool full_float = false;  // 32 bit floats instead of 16
  // For which levels of detail of a ground of nodes are chosen, where not for the picture's own: shows what changes
  // with them alone.
  std::optional<Pose> levels_for = std::nullopt;
  double making_ms = least_making_ms;  // as of Frame
};

// Work of the last frame, and what is held.
struct RenderStats {
  std::int64_t triangles = 0;
  int draw_calls = 0;
  std::int64_t noise_evaluations = 0;  // where pixels compute noise: at the most, by the planet's area in the picture
  std::int64_t texture_reads = 0;      // of pixels, at the most, by the planet's area in the picture
  std::int64_t gpu_bytes = 0;
  int textures = 0;
  std::vector<std::string> programs;
};

class Renderer {
 public:
  // Needs a current context whose caps() have been read and can draw to floats.
  Renderer();

  // Chooses the techniques for a scene and begins to compile what is new for a picture of that effort. 1 when draw will
  // not wait for a shader, else the part that is there.
  double prepare(const Scene& scene, const View& view, Effort effort);

  // Draws into the renderer's own picture of light. view: in pixels drawn.
  void draw(const Scene& scene, const View& view, const Shot& shot);

  // The same in parts: begin, then all rows of the picture, each once. In between others may draw, but nothing else may
  // be asked of this renderer.
  void begin(const Scene& scene, const View& view, const Shot& shot);
  void draw_rows(const Rows& rows);
  // Until what was drawn so far is there.
  void wait() const;

  // Goes on with what a picture that is shown still lacks, as draw does with Effort::live, but draws none. Returns
  // whether one would now show more; where each picture does, at once. Of a whole() picture, for the scene and view it
  // was drawn for.
  bool refine(const Scene& scene, const View& view, double making_ms = least_making_ms);

  // Shows the last drawn picture (of colour) on a screen of any size; antialias smooths the planet's edges.
  void show(const gl::Screen& screen, bool antialias);

  // The picture of light: linear, after exposure, bottom row first, four channels; or a measurement in planet radii.
  [[nodiscard]] std::vector<float> read_light() const { return light_->read_floats(); }

  // What the last draw, or else prepare, decided.
  [[nodiscard]] const Needs& needs() const { return needs_; }
  [[nodiscard]] const Pose& pose() const { return pose_; }
  // Whether the last picture was of the air alone, as one with Effort::soonest is.
  [[nodiscard]] bool only_air() const { return only_air_; }
  // Whether the last picture lacked nothing; the first ones do without what they would have to wait for.
  [[nodiscard]] bool whole() const;
  // Whether it was as fine as the scene asks as well; else further frames refine it.
  [[nodiscard]] bool settled() const;
  [[nodiscard]] RenderStats stats() const;

 private:
  // Builds what the needs call for.
  void choose_techniques(Effort effort);
  // Which of the slots that refine what they show lack nothing.
  [[nodiscard]] std::bitset<5> settled_slots() const;
  // Which part of it is ready.
  double ready();
  void update_slots(const Frame& frame);
  void begin_light(const View& view, const Shot& shot);
  void set_maps(const Frame& frame);
  // Draws the land that the water mirrors, if it mirrors any.
  void draw_mirror();
  // All that is seen of a scene, to where drawing goes.
  void draw_light(const Frame& frame);
  // How much of the picture shows the ground before (GroundPass::part_before).
  [[nodiscard]] double part_before() const;
  [[nodiscard]] Frame frame_of(const Rows& rows) const;

  // A picture of which rows are still to be drawn.
  struct Begun {
    Scene scene;
    View view;
    Shot shot;
    Sea sea;
    std::optional<Mirror> mirror;
  };

  SphereMeshes spheres_;
  gl::UniformBuffer scene_buffer_, frame_buffer_;
  Slot<Ground, GroundPass> ground_;
  Slot<Water, SeaPass> water_;
  Slot<Clouds, CloudsShell> clouds_;
  Slot<Air, AirFresnel> air_;
  Slot<Stars, StarsNoise> stars_;
  Slot<NightSide, NightLights> night_;
  Slot<SunImage, SunDisc> sun_;
  Slot<Rings, RingsPlane> rings_;
  std::optional<LandMirror> land_mirror_;  // where there is water
  std::optional<WaterBackdrop> backdrop_;  // from when the eye has been under water
  PicturePass picture_;
  std::unique_ptr<gl::Target> light_;
  std::optional<LightFade> fade_;  // where a ground may give way to the next
  gl::CubeMap no_ground_;          // all sea
  gl::CubeMap no_clouds_;
  Needs needs_;
  PictureBox planet_box_;
  std::optional<Begun> begun_;
  Effort effort_ = Effort::complete;  // of the last draw
  bool only_air_ = false;
  Pose pose_{};
  std::int64_t noise_evaluations_ = 0, texture_reads_ = 0;
};

}  // namespace terrella
