#pragma once

#include <string_view>

namespace terrella {

// How hands move the camera: around the planet, freely through the air, on foot.
enum class CameraMode { orbit, fly, walk };

struct CameraModeText {
  CameraMode mode;
  std::string_view name, title, help;
};

inline constexpr CameraModeText camera_mode_texts[] = {
    {CameraMode::orbit, "orbit", "Orbit", "Drag turns the planet, the wheel leads nearer and away (key 1)."},
    {CameraMode::fly, "fly", "Fly",
     "W A S D fly along the view, T and G rise and sink, Q and E roll, drag looks around (key 2)."},
    {CameraMode::walk, "walk", "Walk",
     "Down to the ground: W A S D walk, Shift runs, Space jumps, drag looks around (key 3)."},
};

}  // namespace terrella
