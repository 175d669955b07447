#include "adapt/nearest_name.h"

#include <algorithm>
#include <cctype>
#include <numeric>

namespace parmesan {
namespace {

constexpr std::size_t kLongestCompared = 64;  // nobody slips in names longer than this

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// The one name that begins with at least three letters as written; empty when none or several do.
std::string completed(std::string_view written, std::span<const std::string> allowed) {
  constexpr std::size_t fewest = 3;
  if (written.size() < fewest) return {};
  const auto begins = [&written](const std::string& name) { return lower(name).starts_with(lower(written)); };
  const auto found = std::ranges::find_if(allowed, begins);
  return std::ranges::count_if(allowed, begins) == 1 ? *found : std::string();
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row[b.size()];
}

std::string nearest_name(std::string_view written, std::span<const std::string> allowed) {
  if (written.size() > kLongestCompared) return {};
  std::string best;
  std::size_t smallest = std::max<std::size_t>(1, written.size() / 2) + 1;
  for (const std::string& name : allowed) {
    if (name.size() > kLongestCompared) continue;
    const std::size_t distance = edit_distance(lower(written), lower(name));
    if (distance >= smallest || distance >= name.size()) continue;
    smallest = distance;
    best = name;
  }
  return best.empty() ? completed(written, allowed) : best;
}

std::string suggestion(std::string_view written, std::span<const std::string> allowed) {
  const std::string nearest = nearest_name(written, allowed);
  return nearest.empty() ? "" : "; did you mean '" + nearest + "'?";
}

std::string quoted_list(std::span<const std::string> names) {
  constexpr std::size_t most = 100;
  if (names.empty()) return "(none)";
  std::string list;
  for (const std::string& name : names.first(std::min(names.size(), most)))
    list += (list.empty() ? "'" : ", '") + name.substr(0, kLongestCompared) + "'";
  if (names.size() > most) list += " and " + std::to_string(names.size() - most) + " more";
  return list;
}

}  // namespace parmesan
