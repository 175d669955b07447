#include "mesher/io/tag_map.h"

#include <algorithm>

namespace parmesan {

bool TagMap::finish() {
  const auto is_gap = [](std::int64_t a, std::int64_t b) { return b - a != 1; };
  sorted_.clear();
  if (std::adjacent_find(tags_.begin(), tags_.end(), is_gap) == tags_.end()) return true;
  sorted_.reserve(tags_.size());
  for (const std::int64_t tag : tags_) sorted_.emplace_back(tag, static_cast<int>(sorted_.size()));
  std::sort(sorted_.begin(), sorted_.end());
  const auto same_tag = [](const auto& a, const auto& b) { return a.first == b.first; };
  return std::adjacent_find(sorted_.begin(), sorted_.end(), same_tag) == sorted_.end();
}

int TagMap::index(std::int64_t tag) const {
  if (tags_.empty()) return -1;
  if (sorted_.empty()) {
    const bool is_known = tag >= tags_.front() && tag <= tags_.back();
    return is_known ? static_cast<int>(tag - tags_.front()) : -1;
  }
  const auto found = std::lower_bound(sorted_.begin(), sorted_.end(), std::pair(tag, 0));
  return found != sorted_.end() && found->first == tag ? found->second : -1;
}

}  // namespace parmesan
