#include "mesher/io/airfoil_file.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesher/errors.h"
#include "mesher/io/text.h"
#include "mesher/io/triangle_rows.h"

namespace parmesan {
namespace {

constexpr int airfoil_label = 1;
constexpr int trailing_edge_label = 2;

/// As the rows are read; also one that is not finite, for it is no title.
bool is_number(std::string_view word) {
  TextReader in(word, "");
  try {
    in.real("a coordinate");
    return true;
  } catch (const FileValueError&) {
    return true;
  } catch (const FileError&) {
    return false;
  }
}

/// Whether the line consists of two numbers; goes to its end.
bool takes_row(TextReader& in) {
  int num_words = 0;
  bool all_numbers = true;
  for (; !in.at_line_end(); ++num_words) all_numbers = is_number(in.word("a coordinate")) && all_numbers;
  return num_words == 2 && all_numbers;
}

/// A title may hold anything, so its words are not looked at beyond the first line.
void skip_title(TextReader& in) {
  if (in.at_end()) in.fail("the file is empty");
  TextReader row = in;
  if (!takes_row(row)) in.skip_line();
}

std::vector<Point> read_rows(TextReader& in) {
  std::vector<Point> rows;
  while (!in.at_end()) {
    Point& p = rows.emplace_back();
    p.x = real_on_line(in, "the x coordinate");
    p.y = real_on_line(in, "the y coordinate");
    if (!in.at_line_end()) in.fail("a line must have two numbers, x and y");
  }
  if (rows.size() < 3) in.fail("an airfoil needs at least 3 points");
  return rows;
}

/// Lednicer's counts: whole numbers above any coordinate, whose sum is the number of rows that follow.
bool has_counts(const std::vector<Point>& rows) {
  const Point& counts = rows.front();
  return counts.x > 1.0 && counts.y > 1.0 && counts.x + counts.y == static_cast<double>(rows.size() - 1) &&
         counts.x == std::floor(counts.x);
}

/// From the trailing edge along the upper side to the leading edge, which both sides have, and back along the lower
/// one.
std::vector<Point> put_together(const std::vector<Point>& rows) {
  const auto upper_end = rows.begin() + 1 + static_cast<std::ptrdiff_t>(rows.front().x);
  std::vector<Point> outline(rows.begin() + 1, upper_end);
  std::reverse(outline.begin(), outline.end());
  const bool shares_leading_edge = outline.back() == *upper_end;
  outline.insert(outline.end(), upper_end + (shares_leading_edge ? 1 : 0), rows.end());
  return outline;
}

Domain domain_within(std::vector<Point> outline) {
  const bool is_closed = outline.front() == outline.back();
  if (is_closed) outline.pop_back();
  Domain domain;
  domain.inside = Inside::EvenOdd;
  domain.label_names = {{airfoil_label, "airfoil"}};
  const int n = static_cast<int>(outline.size());
  for (int i = 0; i + 1 < n; ++i) domain.segments.push_back({i, i + 1, airfoil_label});
  domain.segments.push_back({n - 1, 0, is_closed ? airfoil_label : trailing_edge_label});
  if (!is_closed) domain.label_names[trailing_edge_label] = "trailing_edge";
  domain.points = std::move(outline);
  return domain;
}

}  // namespace

Domain parse_airfoil(std::string_view text, const std::string& name) {
  TextReader in(text, name);
  skip_title(in);
  const std::vector<Point> rows = read_rows(in);
  return domain_within(has_counts(rows) ? put_together(rows) : rows);
}

Domain read_airfoil(const std::string& path) { return parse_airfoil(read_file(path), path); }

}  // namespace parmesan
