#pragma once

#include "scene/color.hpp"
#include "scene/map_file.hpp"

namespace terrella {

// Everything that the user can set; all that a picture depends on beside its size and the time. Plain data with a
// struct for each group of params.inc: scene.terrain.height, scene.waves.count. Lengths are in metres, angles in
// degrees, a choice is the index of its name (scene/choices.hpp). A scene made here holds the defaults.
struct Scene {
#define GROUP(group, title, help) struct group##_group {
#define FLOAT(group, name, value, min, max, unit, scale, help) double name = value;
#define LENGTH(group, name, value, min, max, slider_max, scale, help) double name = value;
#define INT(group, name, value, min, max, help) int name = value;
#define BOOL(group, name, value, help) bool name = value;
#define COLOR(group, name, value, help) Color name = Color::from_hex(value);
#define CHOICE(group, name, value, choices, help) int name = value;
#define FILE_NAME(group, name, help) MapFile name;
#define END_GROUP(group)                                 \
  bool operator==(const group##_group&) const = default; \
  }                                                      \
  group;
#include "scene/params.inc"
#include "scene/params_undef.inc"

  bool operator==(const Scene&) const = default;
};

}  // namespace terrella
