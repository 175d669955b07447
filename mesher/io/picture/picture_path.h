#pragma once

#include <cstdint>
#include <vector>

#include "mesher/geometry/point.h"

namespace parmesan {

/// Lines and polygons of a picture. Places are kept in hundredths of a pixel, those beyond 10^7 pixels clamped.
class PicturePath {
 public:
  enum class Command : std::uint8_t { MoveTo, LineTo, Close };
  struct Step {
    Command command = Command::MoveTo;
    std::int32_t x = 0;  // of a Close: where its piece began
    std::int32_t y = 0;
  };

  void move_to(const Point& pixels);
  void line_to(const Point& pixels);
  void close();

  bool empty() const { return steps_.empty(); }
  const std::vector<Step>& steps() const { return steps_; }

 private:
  void append(Command command, const Point& pixels);

  std::vector<Step> steps_;
  std::size_t start_ = 0;  // of the current piece
};

}  // namespace parmesan
