// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace fairway::internal {

/// A hash table from the cells of a search's state space to its nodes. It uses open addressing and
/// grows by itself.
class StateTable {
 public:
  static constexpr std::uint32_t kNone = 0xFFFFFFFFU;

  StateTable() : slots_(kFirstSize) {}

  /// The place of a key's index; kNone where the key is new. Valid until the next call.
  [[nodiscard]] std::uint32_t& operator[](std::uint64_t key) {
    if (2 * count_ >= slots_.size()) grow();
    Slot& slot = find(slots_, key);
    if (slot.index == kNone && slot.key != key) {
      slot.key = key;
      ++count_;
    }
    return slot.index;
  }

 private:
  static constexpr std::size_t kFirstSize = 1U << 14U;
  static constexpr std::uint64_t kNoKey = ~0ULL;
  struct Slot {
    std::uint64_t key = kNoKey;
    std::uint32_t index = kNone;
  };

  [[nodiscard]] static Slot& find(std::vector<Slot>& slots, std::uint64_t key) noexcept {
    std::uint64_t hash = key * 0x9E3779B97F4A7C15ULL;
    hash ^= hash >> 29U;
    const std::size_t mask = slots.size() - 1;
    std::size_t i = hash & mask;
    while (slots[i].key != kNoKey && slots[i].key != key)
      i = (i + 1) & mask;
    return slots[i];
  }

  void grow() {
    std::vector<Slot> larger(2 * slots_.size());
    for (const Slot& slot : slots_) {
      if (slot.key != kNoKey) find(larger, slot.key) = slot;
    }
    slots_.swap(larger);
  }

  std::vector<Slot> slots_;
  std::size_t count_ = 0;
};

}  // namespace fairway::internal
