#include "scene/camera_path.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string>

#include "base/text.hpp"
#include "scene/json_reader.hpp"

namespace terrella {
namespace {

constexpr std::string_view kPathKey = "terrella_path", kViewsKey = "views", kTimeKey = "at", kGroup = "camera";
constexpr std::array<std::string_view, 4> kKeys = {kPathKey, kViewsKey, "title", "about"};
constexpr double kLatest = 1e9;  // s

// Of a view.
std::vector<std::string_view> view_keys() {
  std::vector<std::string_view> keys;
  for (const Parameter& parameter : parameters()) {
    if (parameter.group == kGroup) keys.push_back(parameter.name);
  }
  keys.push_back(kTimeKey);
  return keys;
}

Issue no_such_key(const std::string& where, std::string_view key, std::span<const std::string_view> keys) {
  return {where, text_of("there is no such key; allowed are ", listed(keys), did_you_mean(nearest_name(key, keys)))};
}

// Adds an issue for each name that stands there twice.
void check_names(std::span<const Entry> entries, const std::string& where, Issues& issues) {
  std::set<std::string_view> seen;
  for (const Entry& entry : entries) {
    if (!seen.insert(entry.path).second) issues.add(where + shortened(entry.path), "is given more than once.");
  }
}

void check_version(const JsonReading& reading, Issues& issues) {
  const auto is_version = [](const Entry& entry) { return entry.path == kPathKey; };
  const auto entry = std::find_if(reading.entries.begin(), reading.entries.end(), is_version);
  if (entry == reading.entries.end()) {
    issues.add(std::string(kPathKey), text_of("is missing; a path begins with {\"", kPathKey, "\": ", kPathVersion,
                                              ", \"", kViewsKey, "\": […]}."));
  } else if (entry->text != text_of(kPathVersion)) {
    issues.add(entry->path, text_of("version ", shortened(entry->text), " is not known; this program reads version ",
                                    kPathVersion, '.'));
  }
}

void check_keys(const JsonReading& reading, Issues& issues) {
  check_names(reading.entries, "", issues);
  for (const Entry& entry : reading.entries) {
    if (std::find(kKeys.begin(), kKeys.end(), entry.path) == kKeys.end()) {
      issues.add(no_such_key(shortened(entry.path), entry.path, kKeys));
    } else if (entry.path == kViewsKey && entry.value) {
      issues.add(entry.path, text_of(shortened(entry.text), " is not a list of views, [{…}, {…}]."));
    }
  }
}

void check_count(std::size_t views, Issues& issues) {
  if (views < 2) {
    issues.add(std::string(kViewsKey), text_of(views == 0 ? "there is none" : "there is only one",
                                               "; a path leads through 2 to ", kMostViews, " views."));
  } else if (views > kMostViews) {
    issues.add(std::string(kViewsKey),
               text_of("there are ", views, "; a path leads through 2 to ", kMostViews, " views."));
  }
}

void set_time(PathView& view, const Entry& entry, const std::string& where, Issues& issues) {
  const auto* number = entry.value ? std::get_if<double>(&*entry.value) : nullptr;
  if (number != nullptr && *number >= 0.0 && *number <= kLatest) {
    view.at = *number;
  } else {
    const bool is_number = number != nullptr && *number == *number;
    issues.add(where, text_of(shortened(entry.text), is_number ? " is out of range" : " is not a number",
                              "; allowed are 0 to ", kLatest, " s."));
  }
}

void set_camera(PathView& view, const Entry& entry, const std::string& where, Issues& issues) {
  const Parameter* parameter = find_parameter(text_of(kGroup, '.', entry.path));
  if (parameter == nullptr) return issues.add(no_such_key(where, entry.path, view_keys()));
  Scene scene;
  scene.camera = view.camera;
  const std::optional<Issue> issue = assign(scene, *parameter, *entry.value, entry.text);
  if (issue) issues.add(where, issue->sentence);
  view.camera = scene.camera;
}

std::string name_of_view(std::size_t index) { return text_of("view ", index + 1); }

PathView read_view(std::span<const Entry> entries, const Camera& before, std::size_t index, Issues& issues) {
  PathView view{before, std::nullopt};
  check_names(entries, name_of_view(index) + ", ", issues);
  for (const Entry& entry : entries) {
    const std::string where = text_of(name_of_view(index), ", ", shortened(entry.path));
    if (issues.full()) {
      issues.add_unlisted();  // as wording it takes time, which hostile input would multiply
    } else if (entry.path.empty() && entries.size() == 1) {
      issues.add(name_of_view(index), text_of(shortened(entry.text), " is not a view, {…}."));
    } else if (entry.path == kTimeKey) {
      set_time(view, entry, where, issues);
    } else {
      set_camera(view, entry, where, issues);
    }
  }
  return view;
}

void check_times(std::span<const PathView> views, Issues& issues) {
  if (!views.empty() && views[0].at.value_or(0.0) != 0.0) {
    issues.add(text_of(name_of_view(0), ", ", kTimeKey), text_of(*views[0].at, " is not 0, when a path begins."));
  }
  std::size_t last = 0;  // that has a time
  for (std::size_t i = 1; i < views.size(); ++i) {
    if (!views[i].at) continue;
    const double before = views[last].at.value_or(0.0);
    if (*views[i].at <= before) {
      issues.add(text_of(name_of_view(i), ", ", kTimeKey),
                 text_of(*views[i].at, " is not later than ", before, " of ", name_of_view(last), "; times rise."));
    }
    last = i;
  }
}

}  // namespace

std::vector<PathView> read_path(std::string_view text, const Camera& start, Issues& issues) {
  Issues found;
  const JsonReading reading = read_given_json(text, {"path", kViewsKey}, found);
  const bool is_whole = found.empty();
  check_keys(reading, found);
  std::vector<PathView> views;
  for (const std::vector<Entry>& entries : reading.list) {
    views.push_back(read_view(entries, views.empty() ? start : views.back().camera, views.size(), found));
  }
  check_times(views, found);
  if (is_whole) {  // else nobody knows what is missing
    check_version(reading, found);
    check_count(views.size(), found);
  }
  issues.add(found);
  return views;
}

}  // namespace terrella
