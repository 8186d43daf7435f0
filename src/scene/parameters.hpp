#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/issues.hpp"
#include "scene/scene.hpp"

// params.inc as a table that a program can walk: what the panel, JSON, links, the manual and the checks are made from.
namespace terrella {

enum class Type { Float, Int, Bool, Color, Choice, File };
enum class Scale { Linear, Logarithmic };  // how a slider runs

// A parameter's value, outside of a scene. A choice is its name, and so is a file; a colour may also be text,
// "#rrggbb".
using Value = std::variant<double, int, bool, Color, std::string>;

// "0.9", "true", "#ff8800", "icosphere"
std::string to_text(const Value& value);

// Where a scene holds a parameter; a choice is held as its index, an int.
using Field = std::variant<double*, int*, bool*, Color*, MapFile*>;

struct Parameter {
  std::string_view group, name;
  std::string_view path;  // "waves.steepness"
  Type type;
  Value default_value;
  double min, max;        // of Float and Int; for a Choice its indices; else 0 and 0
  double slider_max;      // of lengths: how far a slider goes, in planet radii; else 0
  std::string_view unit;  // "m", "deg", …; empty for plain numbers
  Scale scale;
  std::vector<std::string_view> choices;
  std::string_view help;  // one sentence, without its full stop
  std::size_t offset;     // of its field in a Scene

  bool is_length() const { return slider_max > 0; }
  // Lengths and speeds, but for the radius itself: on a planet ten times as large ten times the value looks the same.
  bool grows_with_planet() const { return (is_length() || unit == "m/s") && path != "planet.radius"; }
  bool is_seed() const { return name == "seed"; }
  Field field(Scene& scene) const;
  Value get(const Scene& scene) const;
};

struct Group {
  std::string_view name, title, help;
};

// All parameters and all groups, in the order of params.inc.
std::span<const Parameter> parameters();
std::span<const Group> groups();

// The scene with every length and every speed (what has the units m and m/s) multiplied: the same, on a planet of
// another size.
Scene scaled(Scene scene, double factor);

// By "group.name"; null if there is none.
const Parameter* find_parameter(std::string_view path);
const Group* find_group(std::string_view name);

// The name that a choice has in this scene: choice_name(scene, "water.model"). The path must be a choice's.
std::string_view choice_name(const Scene& scene, std::string_view path);

// What a user may give: "0 to 1", "true or false", "none, auto, icosphere".
std::string allowed_values(const Parameter& parameter);

// Sets a parameter, or leaves the scene as it was and says why: another type, out of range, not finite, no such choice.
// A whole double passes for an int. A file of another name is yet to be read. `given` is what the sentence quotes,
// where the user's own spelling is known.
std::optional<Issue> assign(Scene& scene, const Parameter& parameter, const Value& value, std::string_view given);
std::optional<Issue> assign(Scene& scene, const Parameter& parameter, const Value& value);

// Sets a parameter from text, as a link or the command line gives it: "waves.steepness", "0.9". A bool may be 1 or 0, a
// colour may lack its '#'.
std::optional<Issue> assign_text(Scene& scene, std::string_view path, std::string_view text);

// "wavs.count: there is no such parameter; did you mean waves.count?"
Issue no_such_parameter(std::string_view path);

}  // namespace terrella
