#include "native/options.hpp"

#include <cstdio>
#include <filesystem>

#include "base/file.hpp"
#include "base/text.hpp"
#include "scene/json.hpp"
#include "scene/link.hpp"
#include "scene/parameters.hpp"
#include "scene/presets.hpp"
#include "scene/quality_path.hpp"

namespace terrella {
namespace {

void apply_preset(const std::string& name, SceneChoice& choice) {
  const Preset* preset = find_preset(name);
  if (preset == nullptr) {
    choice.issues.add(no_such_preset(name));
  } else {
    choice.document = {preset->scene, preset->name};
  }
}

void apply_file(const std::string& path, SceneChoice& choice) {
  const Result<std::string> text = read_file(path, kLongestJson);
  if (!text) {
    choice.issues.add("", text.sentence());
  } else {
    choice.issues.add(load_json(choice.document, *text));
  }
}

// Of a scene in a file, what lies beside it comes first.
std::string path_of_map(const std::string& name, const SceneOptions& options) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (!options.scene_file) return name;
  const fs::path beside = fs::path(*options.scene_file).parent_path() / name;
  return fs::exists(beside, ignored) ? beside.string() : name;
}

void read_map(const SceneOptions& options, SceneChoice& choice) {
  MapFile& file = choice.document.scene.terrain.map;
  if (file.name.empty()) return;
  const Result<std::string> bytes = read_file(path_of_map(file.name, options), largest_map_file);
  if (!bytes) return choice.issues.add("terrain.map", bytes.sentence());
  Result<SharedHeightMap> map = read_height_map(file.name, *bytes);
  if (!map) return choice.issues.add("terrain.map", map.sentence());
  file.map = *map;
}

void apply_quality(const std::string& name, SceneChoice& choice) {
  const QualityStep* step = find_quality(name);
  if (step == nullptr) {
    choice.issues.add(no_such_quality(name));
  } else {
    choice.document.scene = with_quality(choice.document.scene, *step);
  }
}

void apply_setting(const std::string& setting, SceneChoice& choice) {
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos) {
    choice.issues.add("", text_of("--set \"", shortened(setting), "\" is not of the form group.name=value."));
  } else if (auto issue = assign_text(choice.document.scene, setting.substr(0, equals), setting.substr(equals + 1))) {
    choice.issues.add(std::move(*issue));
  }
}

}  // namespace

void add_scene_options(CLI::App& command, SceneOptions& options) {
  const char* const group = "Scene, applied in this order";
  command.add_option("--preset", options.preset, "A preset's name; `terrella presets` lists them")
      ->type_name("NAME")
      ->group(group);
  command.add_option("--scene", options.scene_file, "A scene as JSON")->type_name("FILE.json")->group(group);
  command.add_option("--link", options.link, "A scene as a link, or only the link's query")
      ->type_name("LINK")
      ->group(group);
  command.add_option("--quality", options.quality, "A preset of the parameters of quality, from fast to reference")
      ->type_name("NAME")
      ->group(group);
  command.add_option("--set", options.settings, "A parameter; may be given many times; see `terrella manual`")
      ->type_name("group.name=value")
      ->allow_extra_args(false)
      ->group(group);
}

SceneChoice choose_scene(const SceneOptions& options) {
  SceneChoice choice;
  if (options.preset) apply_preset(*options.preset, choice);
  if (options.scene_file) apply_file(*options.scene_file, choice);
  if (options.link) choice.issues.add(load_link(choice.document, *options.link));
  if (options.quality) apply_quality(*options.quality, choice);
  for (const std::string& setting : options.settings) apply_setting(setting, choice);
  read_map(options, choice);
  return choice;
}

void read_size(const std::string& text, int& width, int& height, int most, Issues& issues) {
  int w = 0, h = 0;
  char rest = 0;
  const bool read = std::sscanf(text.c_str(), "%6dx%6d%c", &w, &h, &rest) == 2;
  if (!read || w < 1 || h < 1 || w > most || h > most) {
    issues.add("--size", text_of(json_quoted(shortened(text)), " is not a size; give WIDTHxHEIGHT, each 1 to ", most,
                                 ", as in 1280x720."));
    return;
  }
  width = w;
  height = h;
}

void check_gl(const std::string& text, Issues& issues) {
  if (text == "core" || text == "es") return;
  issues.add("--gl", text_of(json_quoted(shortened(text)), " is not a kind of OpenGL; there are core and es."));
}

}  // namespace terrella
