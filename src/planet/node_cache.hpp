// Which nodes of a grid are there to be drawn: a fixed number of slots, given to new nodes as old ones are no
// longer used.
#pragma once

#include <cstdint>
#include <list>
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
    std::uint64_t used = 0;         // the frame that used it last
    std::uint64_t leaf = 0;         // the frame that drew it undivided last
    std::uint64_t as_above = 0;     // the frame that drew it in the shape of the level above last
    std::list<int>::iterator turn;  // in the order of use
  };

  // capacity: slots, > 0.
  explicit NodeCache(int capacity);
  NodeCache(NodeCache&&) = default;
  NodeCache& operator=(NodeCache&&) = default;

  void begin_frame() { ++now_; }

  // The slot of a node, or -1.
  [[nodiscard]] int find(const GridNode& node) const;
  [[nodiscard]] const Entry& at(int slot) const { return entries_[static_cast<std::size_t>(slot)]; }

  void use(int slot) {
    Entry& entry = entries_[static_cast<std::size_t>(slot)];
    entry.used = now_;
    by_use_.splice(by_use_.end(), by_use_, entry.turn);
  }
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
  [[nodiscard]] bool has_room() const;

  void clear();

 private:
  std::vector<Entry> entries_;
  std::list<int> by_use_;  // slots, the one that was not used for longest first
  std::size_t capacity_;
  std::unordered_map<std::uint64_t, int> slots_;
  std::uint64_t now_ = 1;
};

}  // namespace terrella
