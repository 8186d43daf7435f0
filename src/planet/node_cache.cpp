#include "planet/node_cache.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace terrella {
namespace {

// A number for each node: its place on its level behind a leading one, which tells the level.
std::uint64_t key_of(const QuadNode& node) {
  const auto level = static_cast<unsigned>(node.level);
  return std::uint64_t{static_cast<unsigned>(node.face)} << 60U |
         ((std::uint64_t{1} << 2U * level) + (std::uint64_t{node.x} << level) + node.y);
}

}  // namespace

NodeCache::NodeCache(int capacity) : capacity_(static_cast<std::size_t>(capacity)) {
  CHECK(capacity > 0, capacity);
  entries_.reserve(capacity_);
  slots_.reserve(2 * capacity_);
}

int NodeCache::find(const QuadNode& node) const {
  const auto found = slots_.find(key_of(node));
  return found == slots_.end() ? -1 : found->second;
}

std::size_t NodeCache::oldest() const {
  const auto found = std::min_element(entries_.begin(), entries_.end(),
                                      [](const Entry& a, const Entry& b) { return a.used < b.used; });
  return static_cast<std::size_t>(found - entries_.begin());
}

bool NodeCache::has_room() const { return entries_.size() < capacity_ || entries_[oldest()].used < now_; }

std::optional<int> NodeCache::insert(const QuadNode& node, const NodeFrame& frame) {
  if (!has_room()) return std::nullopt;
  std::size_t slot = entries_.size();
  if (slot < capacity_) {
    entries_.emplace_back();
  } else {
    slot = oldest();
    slots_.erase(key_of(entries_[slot].node));
  }
  entries_[slot] = {node, frame, now_, 0};
  slots_[key_of(node)] = static_cast<int>(slot);
  return static_cast<int>(slot);
}

void NodeCache::clear() {
  entries_.clear();
  slots_.clear();
}

}  // namespace terrella
