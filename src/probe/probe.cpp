#include "probe/probe.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "base/issues.hpp"
#include "base/numbers.hpp"
#include "base/text.hpp"
#include "probe/arguments.hpp"
#include "probe/evaluate.hpp"

namespace terrella::probe {
namespace {

constexpr std::string_view precisions[] = {"f64", "f32", "gpu"};

struct Request {
  Json id;  // null where there is none
  const Function* function = nullptr;
  Json args;
  Precision precision = Precision::f64;
  std::vector<double> numbers;
  SharedHeightMap map;  // null where the function reads none
  std::string error;
};

const std::vector<Arg>& members_of_request() {
  static const std::vector<Arg> members = {{"id", Kind::object, "", any, true},
                                           {"fn", Kind::word},
                                           {"args", Kind::object},
                                           {"precision", Kind::word, "", any, true}};
  return members;
}

std::string trouble_with_members(const Json& request) {
  for (const auto& [name, value] : request.items()) {
    const auto& members = members_of_request();
    const auto same = [&name = name](const Arg& member) { return member.name == name; };
    if (std::any_of(members.begin(), members.end(), same)) continue;
    std::vector<std::string_view> names;
    for (const Arg& member : members) names.push_back(member.name);
    return text_of("A request has no member ", json_quoted(shortened(name)), did_you_mean(nearest_name(name, names)));
  }
  return {};
}

std::string understand_function(const Json& request, Request& understood) {
  const auto name = request.find("fn");
  if (name == request.end()) return "fn: the name of a function is missing; `terrella probe --list` prints them.";
  if (!name->is_string()) return text_of("fn: ", shortened(name->dump()), " is not the name of a function.");
  const auto& wanted = name->get_ref<const std::string&>();
  understood.function = find_function(wanted);
  if (understood.function != nullptr) return {};
  std::vector<std::string_view> names;
  for (const Function& function : functions()) names.push_back(function.name);
  const std::string_view nearest = nearest_name(wanted, names);
  return text_of("fn: there is no function ", json_quoted(shortened(wanted)),
                 nearest.empty() ? "; `terrella probe --list` prints them." : did_you_mean(nearest));
}

std::string understand_precision(const Json& request, Request& understood) {
  const auto name = request.find("precision");
  if (name == request.end()) return {};
  const std::string wanted = name->is_string() ? name->get<std::string>() : std::string();
  for (std::size_t i = 0; i < std::size(precisions); ++i) {
    if (wanted == precisions[i]) {
      understood.precision = static_cast<Precision>(i);
      return {};
    }
  }
  return text_of("precision: ", shortened(name->dump()), " is none; there are f64, f32 and gpu",
                 did_you_mean(nearest_name(wanted, precisions)));
}

Result<SharedHeightMap> map_of(const Function& function, const Json& args) {
  return function.map ? function.map(args) : SharedHeightMap();
}

std::string understand_args(const Json& request, Request& understood) {
  const auto args = request.find("args");
  if (args == request.end()) return "args: the arguments are missing; they are an object.";
  if (!args->is_object()) return text_of("args: ", shortened(args->dump()), " is not an object.");
  std::string trouble = trouble_with(*args, understood.function->args, understood.function->name);
  if (!trouble.empty()) return trouble;
  Prepared prepared = understood.function->prepare(*args);
  if (!prepared) return prepared.sentence();
  const Result<SharedHeightMap> map = map_of(*understood.function, *args);
  if (!map) return map.sentence();
  understood.map = *map;
  understood.args = *args;
  understood.numbers = *prepared;
  if (understood.precision == Precision::f64 || !all_finite(rounded_numbers(understood.numbers))) return {};
  // What makes sense in double may not do so once it is rounded: then a sentence, and no infinity or worse.
  const Json told = as_told(*args, understood.function->args, understood.precision);
  trouble = trouble_with(told, understood.function->args, understood.function->name);
  if (!trouble.empty()) return "In single precision: " + trouble;
  prepared = understood.function->prepare(told);
  if (!prepared) return "In single precision: " + prepared.sentence();
  trouble = trouble_with_squares(told, understood.function->args);
  if (!trouble.empty()) return "In single precision: " + trouble;
  understood.numbers = *prepared;
  return {};
}

Request understand(const std::string& text) {
  const Line line = read_line(text);
  Request understood;
  understood.id = line.id;
  understood.error = line.trouble;
  const Json& request = line.request;
  if (understood.error.empty()) understood.error = trouble_with_members(request);
  if (understood.error.empty()) understood.error = understand_function(request, understood);
  if (understood.error.empty()) understood.error = understand_precision(request, understood);
  if (understood.error.empty()) understood.error = understand_args(request, understood);
  return understood;
}

std::vector<Output> outputs_of(const Function& function, const Json& args, std::span<const double> answers) {
  return function.shape ? function.shape(args, answers) : function.outputs;
}

std::string begin_of_answer(const Request& request) { return text_of("{\"id\":", request.id.dump()); }

std::string failed(const Request& request, const std::string& sentence) {
  return text_of(begin_of_answer(request), ",\"error\":", json_quoted(sentence), "}");
}

std::string answered(const Request& request, std::span<const double> answers) {
  if (!all_finite(answers)) return failed(request, "not finite");
  const int digits = request.precision == Precision::f64 ? 17 : 9;
  std::string value;
  for (const Output& output : outputs_of(*request.function, request.args, answers)) {
    value += text_of(value.empty() ? "" : ",", json_quoted(output.name), ":");
    if (output.null) {
      value += "null";
    } else if (output.count == 0) {
      value += printed_number(answers[output.first], digits);
    } else {
      for (std::size_t i = 0; i < output.count; ++i) {
        value += text_of(i == 0 ? "[" : ",", printed_number(answers[output.first + i], digits));
      }
      value += "]";
    }
  }
  return text_of(begin_of_answer(request), ",\"value\":{", value, "}}");
}

Answers<double> widened(const Answers<float>& answers) {
  Answers<double> wide{};
  std::copy(answers.begin(), answers.end(), wide.begin());
  return wide;
}

// The error of each answer as a part of what is allowed; the worst of them.
double part_of_allowed(const Answers<float>& answers, std::span<const double> right, std::span<const double> allowed) {
  double worst = 0.0;
  for (std::size_t i = 0; i < allowed.size(); ++i) {
    const double error = std::fabs(static_cast<double>(answers[i]) - right[i]);
    if (!std::isfinite(error)) return std::numeric_limits<double>::infinity();
    if (error > 0.0) worst = std::fmax(worst, error / allowed[i]);  // infinite where nothing is allowed
  }
  return worst;
}

}  // namespace

std::vector<float> rounded_numbers(std::span<const double> numbers) {
  std::vector<float> rounded;
  rounded.reserve(numbers.size());
  constexpr double most = std::numeric_limits<float>::max();
  for (const double x : numbers) {
    // What is too large for a float becomes an infinity; a cast alone would be undefined.
    rounded.push_back(std::fabs(x) <= most ? static_cast<float>(x)
                                           : std::copysign(std::numeric_limits<float>::infinity(),
                                                           static_cast<float>(x < 0.0 ? -1.0F : 1.0F)));
  }
  return rounded;
}

Gpu* Probe::gpu() {
  if (!asked_ && open_gpu_ && open_gpu_()) gpu_ = std::make_unique<Gpu>();
  asked_ = true;
  return gpu_.get();
}

std::vector<std::string> Probe::answer(std::span<const std::string> lines) {
  std::vector<std::string> answers(lines.size());
  std::vector<Request> requests;
  requests.reserve(lines.size());
  std::map<const Function*, std::vector<std::size_t>> drawn;  // those for the GPU, by function
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Request& request = requests.emplace_back(understand(lines[i]));
    if (!request.error.empty()) {
      answers[i] = failed(request, request.error);
    } else if (!all_finite(request.numbers)) {
      answers[i] = failed(request, "not finite");
    } else if (request.precision == Precision::f64) {
      answers[i] = answered(request, evaluate_f64(request.function->name, request.numbers, request.map.get()));
    } else {
      const std::vector<float> numbers = rounded_numbers(request.numbers);
      if (!all_finite(numbers)) {
        answers[i] = failed(request, "not finite");
      } else if (request.precision == Precision::f32) {
        answers[i] = answered(request, widened(evaluate_f32(request.function->name, numbers, request.map.get())));
      } else if (gpu() == nullptr) {
        answers[i] = failed(request, "no gpu");
      } else {
        drawn[request.function].push_back(i);
      }
    }
  }
  for (const auto& [function, places] : drawn) {
    std::vector<Told> told;
    for (const std::size_t i : places) told.push_back({rounded_numbers(requests[i].numbers), requests[i].map});
    const std::vector<Answers<float>> computed = gpu()->evaluate(function->name, told);
    for (std::size_t k = 0; k < places.size(); ++k) {
      answers[places[k]] = answered(requests[places[k]], widened(computed[k]));
    }
  }
  return answers;
}

std::vector<Accuracy> fuzz(int n, unsigned seed, Gpu* gpu) {
  std::vector<Accuracy> accuracies;
  for (const Function& function : functions()) {
    Accuracy accuracy;
    accuracy.function = function.name;
    accuracy.gpu = gpu == nullptr ? -1.0 : 0.0;
    Random random(seed);
    std::vector<Json> tried;
    std::vector<std::vector<double>> prepared;
    std::vector<Told> told;
    const int tries = std::max(std::min(n, 8), n / function.rarity);
    while (accuracy.tries < tries) {
      Json args = function.random(random);
      ++accuracy.tries;
      const std::string trouble = trouble_with(args, function.args, function.name);
      CHECK(trouble.empty(), trouble);
      auto numbers = function.prepare(args);
      if (!numbers) continue;  // arguments that contradict each other
      told.push_back({rounded_numbers(*numbers), *map_of(function, args)});
      prepared.push_back(std::move(*numbers));
      tried.push_back(std::move(args));
    }
    const std::vector<Answers<float>> drawn =
        gpu == nullptr ? std::vector<Answers<float>>() : gpu->evaluate(function.name, told);
    const auto hold = [&](std::size_t i, const Answers<float>& answers, std::span<const double> right, bool on_gpu) {
      double& worst = on_gpu ? accuracy.gpu : accuracy.f32;
      const Case tested = {prepared[i], right, on_gpu, told[i].map.get()};
      const double part = part_of_allowed(answers, right, function.allowed(tested));
      if (part <= worst) return;
      worst = part;
      (on_gpu ? accuracy.worst_gpu : accuracy.worst_f32) = tried[i].dump();
    };
    for (std::size_t i = 0; i < told.size(); ++i) {
      const HeightMap* map = told[i].map.get();
      const Answers<double> right = evaluate_f64(function.name, prepared[i], map);
      if (!all_finite(right)) {
        accuracy.f32 = std::numeric_limits<double>::infinity();
        accuracy.worst_f32 = tried[i].dump();
        continue;
      }
      // `allowed` tells how many answers there are; the rest is 0 in all.
      hold(i, evaluate_f32(function.name, told[i].numbers, map), right, false);
      if (gpu != nullptr) hold(i, drawn[i], right, true);
    }
    accuracies.push_back(std::move(accuracy));
  }
  return accuracies;
}

namespace {

std::string part_in_words(double part) { return part < 0.0 ? "no GPU" : printed_number(part, 2); }

}  // namespace

std::string accuracy_text(std::span<const Accuracy> accuracies) {
  std::string text;
  for (const Accuracy& a : accuracies) {
    std::array<char, 120> line{};
    std::snprintf(line.data(), line.size(), "%-16s %8d tries   f32 %-8s gpu %s\n", std::string(a.function).c_str(),
                  a.tries, part_in_words(a.f32).c_str(), part_in_words(a.gpu).c_str());
    text += line.data();
    if (a.f32 > 1.0) text += text_of("  f32 misses its bound at ", shortened(a.worst_f32, 2000), "\n");
    if (a.gpu > 1.0) text += text_of("  gpu misses its bound at ", shortened(a.worst_gpu, 2000), "\n");
  }
  return text;
}

std::string accuracy_markdown(std::span<const Accuracy> accuracies) {
  std::string text =
      "| function | tries | f32: worst error / allowed | gpu: worst error / allowed |\n"
      "| --- | --- | --- | --- |\n";
  for (const Accuracy& a : accuracies) {
    text +=
        text_of("| `", a.function, "` | ", a.tries, " | ", part_in_words(a.f32), " | ", part_in_words(a.gpu), " |\n");
  }
  return text;
}

}  // namespace terrella::probe
