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

template <class Element>
class KeptParts {
 public:
  // Elements of the buffer.
  struct Range {
    std::size_t first = 0, count = 0;
  };

  void forget() { parts_.clear(); }

  // Where a choice lies. append(chosen, elements): adds what is chosen; send(elements): replaces the buffer. Both are
  // called where it is new. all: it is for a whole picture, so that no other part will be wanted soon.
  template <class Append, class Send>
  Range range_of(Chosen chosen, bool all, const Append& append, const Send& send) {
    for (const Part& part : parts_) {
      if (part.chosen == chosen) return part.range;
    }
    if (all || parts_.size() == most_parts) parts_.clear();
    if (parts_.empty()) elements_.clear();
    const std::size_t first = elements_.size();
    append(chosen, elements_);
    send(elements_);
    parts_.push_back({std::move(chosen), {first, elements_.size() - first}});
    return parts_.back().range;
  }

 private:
  static constexpr std::size_t most_parts = 32;  // more than a picture has, for two that share a mesh

  struct Part {
    Chosen chosen;
    Range range;
  };

  std::vector<Part> parts_;
  std::vector<Element> elements_;  // of the buffer
};

}  // namespace terrella
