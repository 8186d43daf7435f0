// What was chosen of a mesh for each part of a picture, one behind the other in one buffer: while the camera rests, a
// picture that is drawn part by part sends nothing anew.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace terrella {

// What of all there is: places in it.
using Chosen = std::vector<std::uint32_t>;

class KeptParts {
 public:
  // Elements of the buffer.
  struct Range {
    std::size_t first = 0, count = 0;
  };

  // Where a choice lies; null where it is new.
  [[nodiscard]] const Range* find(const Chosen& chosen) const {
    for (const Part& part : parts_) {
      if (part.chosen == chosen) return &part.range;
    }
    return nullptr;
  }

  // Whether the buffer is to begin anew with what comes next. all: that is for a whole picture, so that no other part
  // will be wanted soon.
  bool begin_anew(bool all) {
    const bool anew = all || parts_.empty() || parts_.size() == most_parts;
    if (anew) parts_.clear();
    return anew;
  }

  // From now on it lies there.
  const Range* keep(Chosen chosen, const Range& range) {
    parts_.push_back({std::move(chosen), range});
    return &parts_.back().range;
  }

  void forget() { parts_.clear(); }

 private:
  static constexpr std::size_t most_parts = 32;  // more than a picture has, for two that share a mesh

  struct Part {
    Chosen chosen;
    Range range;
  };

  std::vector<Part> parts_;
};

// The buffer's own content, on the CPU, with what was chosen from it.
template <class Element>
class KeptBuffer {
 public:
  void forget() { parts_.forget(); }

  // append(chosen, elements): adds what is chosen; send(elements): replaces the buffer. Both are called where it is
  // new.
  template <class Append, class Send>
  KeptParts::Range range_of(Chosen chosen, bool all, const Append& append, const Send& send) {
    if (const KeptParts::Range* kept = parts_.find(chosen)) return *kept;
    if (parts_.begin_anew(all)) elements_.clear();
    const std::size_t first = elements_.size();
    append(chosen, elements_);
    send(elements_);
    return *parts_.keep(std::move(chosen), {first, elements_.size() - first});
  }

 private:
  KeptParts parts_;
  std::vector<Element> elements_;
};

}  // namespace terrella
