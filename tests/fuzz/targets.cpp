#include "targets.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/check.hpp"
#include "base/utf8.hpp"
#include "planet/journey.hpp"
#include "scene/camera_path.hpp"
#include "scene/json.hpp"
#include "scene/json_reader.hpp"
#include "scene/link.hpp"
#include "scene/parameters.hpp"

namespace terrella {
namespace {

void check_values(const Scene& scene) {
  Scene copy;
  for (const Parameter& parameter : parameters()) {
    const auto issue = assign(copy, parameter, parameter.get(scene));
    CHECK(!issue, issue->text());
  }
  CHECK(copy == scene);
}

void check_sentences(const Issues& issues) {
  const std::vector<std::string> sentences = issues.sentences();
  CHECK(issues.empty() == sentences.empty());
  CHECK(sentences.size() <= Issues::kMostListed + 1, sentences.size());
  for (const std::string& sentence : sentences) {
    constexpr std::size_t kReadable = 400;
    CHECK(!sentence.empty() && sentence.size() <= kReadable, sentence);
    CHECK(sentence.ends_with('.') || sentence.ends_with('?'), sentence);
    CHECK(find_not_utf8(sentence) == std::string::npos, sentence);
    for (const char c : sentence) CHECK(static_cast<unsigned char>(c) >= 0x20, sentence);
  }
}

void check_saving(const SceneDocument& document) {
  SceneDocument by_json, by_link;
  const std::string json = to_json(document), link = to_link(document);
  CHECK(load_json(by_json, json).empty() && by_json == document, json);
  CHECK(load_link(by_link, link).empty() && by_link == document, link);
}

void check_document(const SceneDocument& document, const Issues& issues) {
  check_values(document.scene);
  check_sentences(issues);
  check_saving(document);
}

}  // namespace

void fuzz_json(std::string_view text) {
  SceneDocument document;
  const Issues issues = load_json(document, text);
  check_document(document, issues);

  // Our own reader forgives more than others do, but what they take it takes.
  const auto parsed = nlohmann::json::parse(text, nullptr, false);
  if (parsed.is_object()) CHECK(read_json(text).trouble.empty(), text);
}

void fuzz_link(std::string_view text) {
  SceneDocument document;
  const Issues issues = load_link(document, text);
  check_document(document, issues);
}

void fuzz_path(std::string_view text) {
  Issues issues;
  const std::vector<PathView> views = read_path(text, {}, issues);
  check_sentences(issues);
  Scene scene;
  scene.terrain.model = scene.water.model = 0;
  for (const PathView& view : views) {
    scene.camera = view.camera;
    check_values(scene);
  }
  if (!issues.empty()) return;
  CHECK(views.size() >= 2);
  const Journey journey(scene, views);
  CHECK(std::isfinite(journey.seconds()) && journey.seconds() > 0.0, journey.seconds());
  for (const double part : {0.0, 0.3, 0.7, 1.0}) {
    scene.camera = journey.at(part * journey.seconds());
    check_values(scene);
  }
}

}  // namespace terrella

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
  switch (data[0] % 3) {
    case 0: terrella::fuzz_json(text); break;
    case 1: terrella::fuzz_link(text); break;
    default: terrella::fuzz_path(text);
  }
  return 0;
}
