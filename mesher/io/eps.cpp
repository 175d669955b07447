#include "mesher/io/eps.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "mesher/io/output_file.h"

namespace parmesan {
namespace {

/// PostScript counts y upwards; the canvas is turned over as a whole, and back for texts.
class EpsCanvas : public Canvas {
 public:
  EpsCanvas(OutputFile& out, const PictureLayout& layout) : out_(out) {
    const auto width = static_cast<int>(std::ceil(layout.width));
    const auto height = static_cast<int>(std::ceil(layout.height));
    out_ << "%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 0 0 " << width << ' ' << height
         << "\n%%LanguageLevel: 2\n%%Pages: 1\n%%EndComments\n"
            "%%BeginProlog\n"
            "/m {moveto} bind def /l {lineto} bind def /z {closepath} bind def /s {stroke} bind def\n"
            "/c {setrgbcolor} bind def /w {setlinewidth} bind def /r {rectfill} bind def\n"
            "/f {gsave fill grestore stroke} bind def\n"
            "%%EndProlog\n%%Page: 1 1\ngsave 0 "
         << height << " translate .01 -.01 scale 1 setlinejoin\n";
  }

  void finish() { out_ << "grestore showpage\n%%EOF\n"; }

  void fill(const PicturePath& path, const std::string& colour) override {
    if (path.empty()) return;
    set_colour(colour);
    out_ << "100 w\n";
    for (const PicturePath::Step& step : path.steps()) {
      write_step(step);
      if (step.command == PicturePath::Command::Close) out_ << "f\n";
    }
  }

  void stroke(const PicturePath& path, const Pen& pen) override {
    if (path.empty()) return;
    set_colour(pen.colour);
    out_ << static_cast<int>(std::lround(100.0 * pen.width_px * pen.opacity)) << " w " << (pen.has_round_ends ? 1 : 0)
         << " setlinecap\n";
    std::size_t size = 0;
    for (const PicturePath::Step& step : path.steps()) {
      const bool is_long = size >= longest_path && step.command == PicturePath::Command::MoveTo;
      if (is_long) out_ << "s\n";
      size = is_long ? 1 : size + 1;
      write_step(step);
    }
    out_ << "s\n";
  }

  void rectangle(const Point& corner, double width, double height, const std::string& colour) override {
    set_colour(colour);
    for (const double value : {corner.x, corner.y, width, height}) number(value);
    out_ << "r\n";
  }

  void text(const Point& at, std::string_view text, const TextStyle& style) override {
    set_colour(style.colour);
    out_ << (style.is_bold ? "/Helvetica-Bold" : "/Helvetica") << " findfont ";
    number(style.size_px);
    out_ << "scalefont setfont gsave ";
    number(at.x);
    number(at.y);
    out_ << "translate 1 -1 scale ";
    write_string(text);
    if (style.anchor != TextStyle::Anchor::Start) {
      out_ << " dup stringwidth pop " << (style.anchor == TextStyle::Anchor::End ? "-1" : "-.5") << " mul";
    } else {
      out_ << " 0";
    }
    out_ << " 0 m show grestore\n";
  }

 private:
  static constexpr std::size_t longest_path = 1000;  // interpreters may hold no more than 1500 points

  void number(double pixels) { out_ << static_cast<int>(std::lround(100.0 * std::clamp(pixels, -1e7, 1e7))) << ' '; }

  /// From "#rrggbb" to three numbers from 0 to 1.
  void set_colour(const std::string& colour) {
    for (std::size_t i = 1; i < colour.size(); i += 2) {
      int value = 0;
      std::from_chars(colour.data() + i, colour.data() + i + 2, value, 16);
      out_ << std::round(value / 255.0 * 1000.0) / 1000.0 << ' ';
    }
    out_ << "c\n";
  }

  void write_step(const PicturePath::Step& step) {
    if (step.command == PicturePath::Command::Close) {
      out_ << "z ";
    } else {
      out_ << int{step.x} << ' ' << int{step.y} << (step.command == PicturePath::Command::MoveTo ? " m\n" : " l\n");
    }
  }

  /// In parentheses, which are escaped within.
  void write_string(std::string_view text) {
    out_ << '(';
    for (const char c : text) {
      if (c == '(' || c == ')' || c == '\\') out_ << '\\';
      const bool is_continuation = (static_cast<unsigned char>(c) & 0xc0) == 0x80;  // of a character of several bytes
      if (!is_continuation) out_ << (c >= ' ' && c <= '~' ? c : '?');
    }
    out_ << ')';
  }

  OutputFile& out_;
};

}  // namespace

void write_eps(const std::string& path, const Mesh& mesh, const PictureOptions& options) {
  const PictureLayout layout = picture_layout(mesh, options);
  OutputFile out(path);
  EpsCanvas canvas(out, layout);
  draw_mesh(canvas, mesh, layout, options);
  canvas.finish();
  out.commit();
}

}  // namespace parmesan
