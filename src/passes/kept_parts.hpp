// What was chosen of a mesh for each part of a picture, one behind the other in one buffer: while the camera rests, a
// picture that is drawn part by part sends nothing anew.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace terrella {

// Choice: says what is chosen; Element: of the buffer.
template <class Choice, class Element>
class KeptParts {
 public:
  struct Range {
    std::size_t first = 0, count = 0;  // elements
  };

  void forget() {
    parts_.clear();
    elements_.clear();
  }

  // Where a choice lies in the buffer. all: it is for a whole picture, so that no other will be wanted soon.
  // append(choice, elements): adds what is chosen; send(elements): replaces the buffer. Both are called where the choice is new.
  template <class Append, class Send>
  Range range_of(Choice choice, bool all, const Append& append, const Send& send) {
    for (const Part& part : parts_) {
      if (part.choice == choice) return part.range;
    }
    if (all || parts_.size() == most_parts) forget();
    const std::size_t first = elements_.size();
    append(choice, elements_);
    send(elements_);
    parts_.push_back({std::move(choice), {first, elements_.size() - first}});
    return parts_.back().range;
  }

 private:
  static constexpr std::size_t most_parts = 32;  // as many as a picture has, for two that share a mesh

  struct Part {
    Choice choice;
    Range range;
  };

  std::vector<Part> parts_;
  std::vector<Element> elements_;
};

}  // namespace terrella
