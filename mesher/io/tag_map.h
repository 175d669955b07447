#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "mesher/index.h"

namespace parmesan {

/// Finds the index of a tag, 0 for the first one that was added.
class TagMap {
 public:
  void reserve(std::size_t size) { tags_.reserve(size); }
  void add(std::int64_t tag) { tags_.push_back(tag); }

  /// To be called after the last add. False when a tag was added twice. Cost: O(n), O(n log n) for tags with gaps.
  bool finish();

  std::size_t size() const { return tags_.size(); }
  std::int64_t tag(int index) const { return tags_[at(index)]; }

  /// -1 for a tag that was not added. Cost: O(1), O(log n) for tags with gaps.
  int index(std::int64_t tag) const;

 private:
  std::vector<std::int64_t> tags_;
  std::vector<std::pair<std::int64_t, int>> sorted_;  // empty when the tags follow each other
};

}  // namespace parmesan
