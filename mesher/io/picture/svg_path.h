#pragma once

#include <string>

#include "mesher/geometry/point.h"

namespace parmesan {

/// Collects the data of an SVG path in hundredths of a pixel, as short as relative whole numbers
/// make it; to be drawn in a group with scale(.01).
class SvgPath {
 public:
  void move_to(const Point& pixels);
  void line_to(const Point& pixels);
  void close();

  bool empty() const { return data_.empty(); }
  const std::string& data() const { return data_; }

 private:
  struct Place {
    long x = 0;
    long y = 0;
  };
  static Place rounded(const Point& pixels);
  void append(char command, const Place& place);

  std::string data_;
  Place current_;
  Place start_;            // of the current piece, where the pen returns when it is closed
  char last_command_ = 0;  // a repeated one need not be written
};

}  // namespace parmesan
