#pragma once

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "base/issues.hpp"
#include "scene/document.hpp"

namespace terrella {

// The options by which every subcommand that draws is told its scene.
struct SceneOptions {
  std::optional<std::string> preset;
  std::optional<std::string> scene_file;
  std::optional<std::string> link;
  std::optional<std::string> quality;
  std::vector<std::string> settings;  // "group.name=value"
};

// Adds --preset, --scene, --link, --quality and --set to a subcommand. `options` must outlive the parsing.
void add_scene_options(CLI::App& command, SceneOptions& options);

struct SceneChoice {
  SceneDocument document;
  Issues issues;  // if there are any, the command ends with exit code 2 and writes nothing
};

// The scene that the options ask for: the default, then the preset, the file, the link, the quality and the
// settings, in this order; with the map that it names, beside the scene's file or from the working directory.
SceneChoice choose_scene(const SceneOptions& options);

// Reads the value of --size, "1280x720", each side 1 to most pixels; else leaves them and says why.
void read_size(const std::string& text, int& width, int& height, int most, Issues& issues);

// Says so where the value of --gl is no kind of OpenGL.
void check_gl(const std::string& text, Issues& issues);

}  // namespace terrella
