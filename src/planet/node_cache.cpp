#include "planet/node_cache.hpp"

#include <algorithm>

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

std::size_t NodeCache::oldest() const {
  const auto found = std::min_element(entries_.begin(), entries_.end(),
                                      [](const Entry& a, const Entry& b) { return a.used < b.used; });
  return static_cast<std::size_t>(found - entries_.begin());
}

std::optional<std::size_t> NodeCache::free_slot() const {
  if (entries_.size() < capacity_) return entries_.size();
  const std::size_t slot = oldest();
  return entries_[slot].used < now_ ? std::optional(slot) : std::nullopt;
}

std::optional<int> NodeCache::insert(const GridNode& node, const NodeFrame& frame) {
  const std::optional<std::size_t> slot = free_slot();
  if (!slot) return std::nullopt;
  if (*slot == entries_.size()) {
    entries_.emplace_back();
  } else {
    slots_.erase(key_of(entries_[*slot].node));
  }
  entries_[*slot] = {node, frame, now_, 0, 0};
  return slots_[key_of(node)] = static_cast<int>(*slot);
}

void NodeCache::clear() {
  entries_.clear();
  slots_.clear();
}

}  // namespace terrella
