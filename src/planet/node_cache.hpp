// Which nodes of a grid are there to be drawn: a fixed number of slots, given to new nodes as old ones are no
// longer used.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "planet/node_mesh.hpp"

namespace terrella {

class NodeCache {
 public:
  struct Entry {
    GridNode node;
    NodeFrame frame;
    std::uint64_t used = 0;      // the frame that used it last
    std::uint64_t leaf = 0;      // the frame that drew it undivided last
    std::uint64_t as_above = 0;  // the frame that drew it in the shape of the level above last
  };

  // capacity: slots, > 0.
  explicit NodeCache(int capacity);

  void begin_frame() { ++now_; }

  // The slot of a node, or -1.
  [[nodiscard]] int find(const GridNode& node) const;
  [[nodiscard]] const Entry& at(int slot) const { return entries_[static_cast<std::size_t>(slot)]; }

  void use(int slot) { entries_[static_cast<std::size_t>(slot)].used = now_; }
  // Of this frame: the node is drawn as it is.
  void make_leaf(int slot, bool as_above) {
    Entry& entry = entries_[static_cast<std::size_t>(slot)];
    entry.leaf = now_;
    if (as_above) entry.as_above = now_;
  }
  // Whether it is drawn so, and in the shape of the level above.
  [[nodiscard]] bool is_as_above(int slot) const { return entries_[static_cast<std::size_t>(slot)].as_above == now_; }
  [[nodiscard]] bool is_leaf(int slot) const { return entries_[static_cast<std::size_t>(slot)].leaf == now_; }

  // Takes in a node that is not there, in place of the one that was not used for longest; returns its slot, or nothing
  // where all are used in this frame.
  std::optional<int> insert(const GridNode& node, const NodeFrame& frame);
  // Whether insert would find a slot.
  [[nodiscard]] bool has_room() const { return free_slot().has_value(); }

  void clear();

 private:
  [[nodiscard]] std::size_t oldest() const;
  [[nodiscard]] std::optional<std::size_t> free_slot() const;

  std::vector<Entry> entries_;
  std::size_t capacity_;
  std::unordered_map<std::uint64_t, int> slots_;
  std::uint64_t now_ = 1;
};

}  // namespace terrella
