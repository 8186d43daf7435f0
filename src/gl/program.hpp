// A vertex and a fragment shader, compiled and linked in the background where the driver can.
#pragma once

#include <string>
#include <string_view>

#include "gl/handle.hpp"
#include "gl/ledger.hpp"

namespace terrella::gl {

class Program {
 public:
  // Starts to compile shaders/<name>.vert and shaders/<name>.frag; vertex names another vertex shader if given.
  explicit Program(std::string_view name, std::string_view vertex = {});

  // True once use() will not wait for this program to compile. Where the driver does not tell, the first call finishes
  // the work itself.
  bool ready();

  // Makes it the current program, waiting for it if need be. Stops the program if the shaders are wrong.
  void use();

  // Sets a uniform of the current program by name; a name the shaders do not use is ignored, as in OpenGL.
  void set(const char* name, int value) const;
  void set(const char* name, float value) const;
  void set(const char* name, float x, float y) const;
  void set(const char* name, float x, float y, float z, float w) const;

  [[nodiscard]] const std::string& name() const { return listed_.name(); }
  [[nodiscard]] GLuint id() const { return handle_.name(); }

 private:
  void finish();

  ListedProgram listed_;
  ProgramHandle handle_;
  bool linked_ = false;
  bool finished_ = false;  // asked what it needs, and told where blocks and textures are
};

// Texture units and uniform blocks have the same place in every program.
enum Unit : int {
  unit_ground = 0,
  unit_clouds = 1,
  unit_image = 2,
  unit_nodes = 3,  // seven of them
  unit_heights = 10,
  unit_mirror = 11,
  unit_mirror_depths = 12
};
enum Block : GLuint {
  block_scene = 0,
  block_frame = 1,
  block_waves = 2,
  block_layers = 3,
  block_near_waves = 4,
  block_more_waves = 5
};

}  // namespace terrella::gl
