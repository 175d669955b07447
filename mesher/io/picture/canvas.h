#pragma once

#include <string>
#include <string_view>

#include "mesher/io/picture/picture_path.h"

namespace parmesan {

/// How lines are drawn.
struct Pen {
  std::string colour;  // "#rrggbb"
  double width_px = 1.0;
  double opacity = 1.0;
  bool has_round_ends = false;
};

/// How a text is drawn.
struct TextStyle {
  enum class Anchor { Start, Middle, End };
  Anchor anchor = Anchor::Start;  // which part of the text is at its place
  double size_px = 11.0;
  bool is_bold = false;
  std::string colour = "#374151";
};

/// What a picture is drawn on, from back to front. Places are in pixels, y downwards.
class Canvas {
 public:
  virtual ~Canvas() = default;

  /// Fills the polygons of a path, and a line of one pixel around each, which covers the seams between them.
  virtual void fill(const PicturePath& path, const std::string& colour) = 0;

  virtual void stroke(const PicturePath& path, const Pen& pen) = 0;

  /// corner: the upper left one.
  virtual void rectangle(const Point& corner, double width, double height, const std::string& colour) = 0;

  virtual void text(const Point& at, std::string_view text, const TextStyle& style) = 0;
};

}  // namespace parmesan
