#include "native/cmd_probe.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "native/egl_context.hpp"
#include "native/failures.hpp"
#include "probe/probe.hpp"

namespace terrella {
namespace {

struct ProbeOptions {
  bool list = false;
  bool markdown = false;
  int fuzz = -1;  // not asked for
  unsigned seed = 1U;
  std::string gl = "core";
};

void print(const std::vector<std::string>& answers) {
  for (const std::string& answer : answers) {
    std::fwrite(answer.data(), 1, answer.size(), stdout);
    std::fputc('\n', stdout);
  }
  std::fflush(stdout);
}

// Answers lines as they come: all that have arrived at once together, so that who asks one by one does not wait and who
// sends many has them drawn together.
void answer_standard_input(probe::Probe& probe) {
  std::string pending;
  bool too_long = false;  // the rest of a line whose beginning was already given up
  std::vector<char> chunk(1U << 18U);
  while (true) {
    const ssize_t got = read(STDIN_FILENO, chunk.data(), chunk.size());
    if (got < 0 && errno == EINTR) continue;
    if (got > 0) pending.append(chunk.data(), static_cast<std::size_t>(got));
    if (got <= 0 && !pending.empty()) pending += '\n';  // a last line without an end
    std::vector<std::string> lines;
    std::size_t start = 0;
    for (std::size_t end = pending.find('\n'); end != std::string::npos; end = pending.find('\n', start)) {
      if (!too_long) lines.push_back(pending.substr(start, end - start));
      too_long = false;
      start = end + 1;
    }
    pending.erase(0, start);
    if (pending.size() > probe::kLongestLine) {
      if (!too_long) lines.push_back(pending);
      too_long = true;
      pending.clear();
    }
    if (!lines.empty()) print(probe.answer(lines));
    if (got <= 0) return;
  }
}

int try_all(const ProbeOptions& options, probe::Probe& probe) {
  const auto accuracies = probe::fuzz(options.fuzz, options.seed, probe.gpu());
  std::fputs((options.markdown ? accuracy_markdown(accuracies) : accuracy_text(accuracies)).c_str(), stdout);
  const bool held = std::all_of(accuracies.begin(), accuracies.end(),
                                [](const probe::Accuracy& a) { return a.f32 <= 1.0 && a.gpu <= 1.0; });
  return held ? 0 : report_failure("A function misses its bound: its error is more than once what is allowed.");
}

int run(const ProbeOptions& options) {
  Issues issues;
  const bool fuzzes = options.fuzz != -1;
  if (fuzzes && (options.fuzz < 1 || options.fuzz > 10'000'000)) {
    issues.add("--fuzz", "must be a whole number, 1 to 10000000.");
  }
  if (options.markdown && !fuzzes) issues.add("--markdown", "lays out what --fuzz finds; give both.");
  if (options.gl != "core" && options.gl != "es") {
    issues.add("--gl", text_of(json_quoted(shortened(options.gl)), " is not a kind of OpenGL; there are core and es."));
  }
  if (!issues.empty()) return report_bad_input(issues);
  if (options.list) {
    for (const probe::Function& function : probe::functions()) std::puts(std::string(function.name).c_str());
    return 0;
  }
  std::unique_ptr<EglContext> context;  // outlives the probe, whose objects live in it
  probe::Probe probe([&] {
    auto made = EglContext::make(options.gl == "es" ? Api::es : Api::core);
    if (made) context = std::move(*made);
    return static_cast<bool>(made);
  });
  if (fuzzes) return try_all(options, probe);
  answer_standard_input(probe);
  return 0;
}

}  // namespace

void add_probe_command(CLI::App& program, int& exit_code) {
  CLI::App* command = program.add_subcommand("probe", "Single functions of the shaders: JSON lines in, JSON lines out");
  const auto options = std::make_shared<ProbeOptions>();
  command->add_flag("--list", options->list, "Print the names of the functions");
  command->add_option("--fuzz", options->fuzz,
                      "Try each function on N sets of arguments: single precision and GPU against double");
  command->add_flag("--markdown", options->markdown, "Print what --fuzz finds as a table");
  command->add_option("--seed", options->seed, "Which arguments --fuzz tries (1)");
  command->add_option("--gl", options->gl, "core or es (core)");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace terrella
