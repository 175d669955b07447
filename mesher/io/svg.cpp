#include "mesher/io/svg.h"

#include <algorithm>
#include <cmath>

#include "mesher/io/output_file.h"
#include "mesher/io/xml_text.h"

namespace parmesan {
namespace {

/// The data of a path in hundredths of a pixel, as short as relative whole numbers make it.
class PathData {
 public:
  explicit PathData(const PicturePath& path) {
    for (const PicturePath::Step& step : path.steps()) append(step);
  }

  const std::string& text() const { return text_; }

 private:
  void append(const PicturePath::Step& step) {
    if (step.command == PicturePath::Command::Close) {
      text_ += last_command_ = 'z';
    } else {
      append_number_pair(step.command == PicturePath::Command::MoveTo ? 'm' : 'l', step);
    }
    last_ = step;
  }

  void append_number_pair(char command, const PicturePath::Step& step) {
    const std::string dx = std::to_string(step.x - last_.x);
    const std::string dy = std::to_string(step.y - last_.y);
    const bool is_repeated = command == last_command_ && command == 'l';
    if (!is_repeated) text_ += command;
    if (is_repeated && dx.front() != '-') text_ += ' ';  // a sign separates numbers too
    text_ += dx;
    if (dy.front() != '-') text_ += ' ';
    text_ += dy;
    last_command_ = command;
  }

  std::string text_;
  PicturePath::Step last_;
  char last_command_ = 0;  // a repeated one need not be written
};

class SvgCanvas : public Canvas {
 public:
  SvgCanvas(OutputFile& out, const PictureLayout& layout) : out_(out) {
    out_ << "<svg xmlns=\"http://www.w3.org/2000/svg\"";
    attribute("width", layout.width);
    attribute("height", layout.height);
    out_ << " viewBox=\"0 0 ";
    number(layout.width);
    out_ << ' ';
    number(layout.height);
    out_ << "\" font-family=\"Helvetica,Arial,sans-serif\">\n";
  }

  void finish() { out_ << "</svg>\n"; }

  void fill(const PicturePath& path, const std::string& colour) override {
    if (path.empty()) return;
    out_ << "<path fill=\"" << colour << "\" stroke=\"" << colour
         << "\" stroke-width=\"100\" stroke-linejoin=\"round\"";
    end_path(path);
  }

  void stroke(const PicturePath& path, const Pen& pen) override {
    if (path.empty()) return;
    out_ << "<path fill=\"none\" stroke=\"" << pen.colour << '"';
    attribute("stroke-width", 100.0 * pen.width_px);
    if (pen.opacity < 1.0) attribute("stroke-opacity", pen.opacity);
    if (pen.has_round_ends) out_ << " stroke-linecap=\"round\"";
    end_path(path);
  }

  void rectangle(const Point& corner, double width, double height, const std::string& colour) override {
    out_ << "<rect shape-rendering=\"crispEdges\"";
    attribute("x", corner.x);
    attribute("y", corner.y);
    attribute("width", width);
    attribute("height", height);
    out_ << " fill=\"" << colour << "\"/>\n";
  }

  void text(const Point& at, std::string_view text, const TextStyle& style) override {
    out_ << "<text";
    attribute("x", at.x);
    attribute("y", at.y);
    attribute("font-size", style.size_px);
    if (style.is_bold) out_ << " font-weight=\"600\"";
    if (style.anchor == TextStyle::Anchor::Middle) out_ << " text-anchor=\"middle\"";
    if (style.anchor == TextStyle::Anchor::End) out_ << " text-anchor=\"end\"";
    out_ << " fill=\"" << style.colour << "\">" << xml_escaped(text) << "</text>\n";
  }

 private:
  /// With two decimals, as short as possible. Beyond 10^12: clamped.
  void number(double value) { out_ << std::round(100.0 * std::clamp(value, -1e12, 1e12)) / 100.0; }

  void attribute(const char* name, double value) {
    out_ << ' ' << name << "=\"";
    number(value);
    out_ << '"';
  }

  void end_path(const PicturePath& path) {
    out_ << " transform=\"scale(.01)\" d=\"" << PathData(path).text() << "\"/>\n";
  }

  OutputFile& out_;
};

}  // namespace

void write_svg(const std::string& path, const Mesh& mesh, const PictureOptions& options) {
  const PictureLayout layout = picture_layout(mesh, options);
  OutputFile out(path);
  SvgCanvas canvas(out, layout);
  draw_mesh(canvas, mesh, layout, options);
  canvas.finish();
  out.commit();
}

}  // namespace parmesan
