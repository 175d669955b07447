#include "mesher/errors.h"
#include "mesher/geometry/segment_path.h"
#include "mesher/index.h"
#include "mesher/io/output_file.h"
#include "mesher/io/text.h"
#include "mesher/io/triangle_files.h"
#include "mesher/io/triangle_rows.h"

namespace parmesan {
namespace {

void read_segments(TextReader& in, const TriangleNodes& nodes, Domain& domain) {
  const int count = in.count("the number of segments", 3);
  in.skip_line();
  domain.segments.resize(static_cast<std::size_t>(count));
  int base = nodes.base;
  for (int i = 0; i < count; ++i) {
    // Segments, holes and regions are numbered from 0 or 1 on their own.
    if (i == 0) base = in.index("the number of the first segment", 0, 2);
    if (i > 0) start_row(in, base, i);
    Segment& segment = domain.segments[at(i)];
    segment.a = index_on_line(in, "the end point of a segment", nodes);
    segment.b = index_on_line(in, "the end point of a segment", nodes);
    segment.label = integer_on_line_or(in, "the marker of a segment", 0);
    in.skip_line();
  }
}

void read_holes(TextReader& in, Domain& domain) {
  const int count = in.count("the number of holes", 3);
  in.skip_line();
  domain.holes.resize(static_cast<std::size_t>(count));
  for (Point& hole : domain.holes) {
    in.integer("the number of a hole");
    hole.x = real_on_line(in, "the x coordinate of a hole");
    hole.y = real_on_line(in, "the y coordinate of a hole");
    in.skip_line();
  }
}

void read_regions(TextReader& in, Domain& domain) {
  const int count = in.count("the number of regions", 4);
  in.skip_line();
  domain.regions.resize(static_cast<std::size_t>(count));
  for (RegionSeed& seed : domain.regions) {
    in.integer("the number of a region");
    seed.point.x = real_on_line(in, "the x coordinate of a region");
    seed.point.y = real_on_line(in, "the y coordinate of a region");
    seed.region = region_on_line(in);
    in.skip_line();
  }
}

/// nodes: those of the .node file, or the text's own.
Domain read_after_nodes(TextReader& in, TriangleNodes nodes) {
  Domain domain;
  domain.first_number = nodes.base;
  read_segments(in, nodes, domain);
  if (!in.at_end()) read_holes(in, domain);
  if (!in.at_end()) read_regions(in, domain);
  in.require_end("the regions");
  domain.points = std::move(nodes.points);
  return domain;
}

}  // namespace

Domain parse_poly(std::string_view text, const std::string& name) {
  TextReader in(text, name);
  TriangleNodes nodes = read_triangle_nodes(in);
  if (nodes.points.empty()) in.fail("the file has no vertices");
  return read_after_nodes(in, std::move(nodes));
}

Domain read_poly(const std::string& path) {
  const std::string text = read_file(path);
  TextReader in(text, path);
  TriangleNodes nodes = read_triangle_nodes(in);
  if (!nodes.points.empty()) return read_after_nodes(in, std::move(nodes));
  const std::string node_path = with_suffix(path, ".node");
  const std::string node_text = read_file(node_path);
  TextReader node_in(node_text, node_path);
  return read_after_nodes(in, read_triangle_nodes(node_in));
}

void check_without_cracks(const std::string& path, const Domain& domain) {
  for (const Segment& s : domain.segments)
    if (s.label_right) throw FileError(path, 0, "a .poly file cannot express cracks, which have a label on each side");
}

void write_poly(const std::string& path, const Domain& domain) {
  if (has_curves(domain)) throw FileError(path, 0, "a .poly file cannot express curves, only straight segments");
  if (domain.inside == Inside::EvenOdd) {
    throw FileError(path, 0, "a .poly file cannot express a domain by the even-odd rule: it needs seeds of holes");
  }
  check_without_cracks(path, domain);
  OutputFile out(path);
  out << domain.points.size() << " 2 0 0\n";
  int row = 0;
  for (const Point& point : domain.points) out << ++row << ' ' << point.x << ' ' << point.y << '\n';
  out << domain.segments.size() << " 1\n";
  row = 0;
  for (const Segment& s : domain.segments) out << ++row << ' ' << s.a + 1 << ' ' << s.b + 1 << ' ' << s.label << '\n';
  out << domain.holes.size() << '\n';
  row = 0;
  for (const Point& hole : domain.holes) out << ++row << ' ' << hole.x << ' ' << hole.y << '\n';
  out << domain.regions.size() << '\n';
  row = 0;
  for (const RegionSeed& seed : domain.regions) {
    out << ++row << ' ' << seed.point.x << ' ' << seed.point.y << ' ' << seed.region << " -1\n";
  }
  out.commit();
}

}  // namespace parmesan
