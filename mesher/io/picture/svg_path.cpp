#include "mesher/io/picture/svg_path.h"

#include <cmath>

namespace parmesan {

SvgPath::Place SvgPath::rounded(const Point& pixels) {
  return {std::lround(100.0 * pixels.x), std::lround(100.0 * pixels.y)};
}

void SvgPath::append(char command, const Place& place) {
  const std::string dx = std::to_string(place.x - current_.x);
  const std::string dy = std::to_string(place.y - current_.y);
  const bool repeated = command == last_command_;
  if (!repeated) data_ += command;
  if (repeated && dx.front() != '-') data_ += ' ';  // a sign separates numbers too
  data_ += dx;
  if (dy.front() != '-') data_ += ' ';
  data_ += dy;
  last_command_ = command;
  current_ = place;
}

// Relative to the end of the piece before, which the first piece does not have.
void SvgPath::move_to(const Point& pixels) {
  last_command_ = 0;
  start_ = rounded(pixels);
  append('m', start_);
}

void SvgPath::line_to(const Point& pixels) { append('l', rounded(pixels)); }

void SvgPath::close() {
  data_ += 'z';
  last_command_ = 'z';
  current_ = start_;
}

}  // namespace parmesan
