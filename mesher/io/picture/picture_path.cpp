#include "mesher/io/picture/picture_path.h"

#include <algorithm>
#include <cmath>

namespace parmesan {
namespace {

std::int32_t rounded(double pixels) {
  return static_cast<std::int32_t>(std::lround(100.0 * std::clamp(pixels, -1e7, 1e7)));
}

}  // namespace

void PicturePath::append(Command command, const Point& pixels) {
  steps_.push_back({command, rounded(pixels.x), rounded(pixels.y)});
}

void PicturePath::move_to(const Point& pixels) {
  start_ = steps_.size();
  append(Command::MoveTo, pixels);
}

void PicturePath::line_to(const Point& pixels) { append(Command::LineTo, pixels); }

void PicturePath::close() { steps_.push_back({Command::Close, steps_[start_].x, steps_[start_].y}); }

}  // namespace parmesan
