#include "planet/node_cache.hpp"

#include "base/check.hpp"

namespace terrella {
namespace {

// A number for each node: its place on its level behind a leading one, which tells the level.
std::uint64_t key_of(const GridNode& node) {
  const auto level = static_cast<unsigned>(node.level);
  return std::uint64_t{static_cast<unsigned>(node.face)} << 59U |
         ((std::uint64_t{1} << 2U * level) + (std::uint64_t{node.x} << level) + node.y);
}

}  // namespace

NodeCache::NodeCache(int capacity) : capacity_(static_cast<std::size_t>(capacity)) {
  CHECK(capacity > 0, capacity);
  entries_.reserve(capacity_);
  slots_.reserve(2 * capacity_);
}

int NodeCache::find(const GridNode& node) const {
  const auto found = slots_.find(key_of(node));
  return found == slots_.end() ? -1 : found->second;
}

bool NodeCache::has_room() const { return entries_.size() < capacity_ || at(by_use_.front()).used < now_; }

std::optional<int> NodeCache::insert(const GridNode& node, const NodeFrame& frame) {
  if (!has_room()) return std::nullopt;
  if (entries_.size() < capacity_) {
    by_use_.push_front(static_cast<int>(entries_.size()));
    entries_.emplace_back();
  } else {
    slots_.erase(key_of(at(by_use_.front()).node));
  }
  const auto turn = by_use_.begin();
  const int slot = *turn;
  entries_[static_cast<std::size_t>(slot)] = {node, frame, 0, 0, 0, turn};
  use(slot);
  return slots_[key_of(node)] = slot;
}

void NodeCache::clear() {
  entries_.clear();
  by_use_.clear();
  slots_.clear();
}

}  // namespace terrella
