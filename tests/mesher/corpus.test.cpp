#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "mesher/errors.h"
#include "mesher/generate.h"
#include "mesher/geometry/clean.h"
#include "mesher/triangulation/check.h"
#include "mesher/triangulation/conversion.h"
#include "mesher/triangulation/triangulate.h"
#include "tests/oracle/domain_cover.h"
#include "tests/oracle/mesh_checker.h"
#include "tests/support/box.h"
#include "tests/support/corpus.h"
#include "tests/support/shared.h"

// The public geometries beside the checkout, classified and triangulated by other programs.

using namespace parmesan;
using support::Box;
using support::box_of;
using support::CorpusEntry;
using support::layer_in;

namespace {

/// Points and open chains get a frame, so that there is something to mesh.
Domain framed(Domain domain) {
  const Box box = box_of(domain.points);
  const double d = 0.1 * box.diameter();
  const int n = static_cast<int>(domain.points.size());
  domain.points.insert(domain.points.end(), {{box.low.x - d, box.low.y - d},
                                             {box.high.x + d, box.low.y - d},
                                             {box.high.x + d, box.high.y + d},
                                             {box.low.x - d, box.high.y + d}});
  for (int i = 0; i < 4; ++i) domain.segments.push_back({n + i, n + (i + 1) % 4, n + i});
  domain.inside = Inside::HoleSeeds;
  return domain;
}

bool encloses_area(const CorpusEntry& entry) { return entry.triangles > 0; }

Domain domain_of(const std::string& corpus, const CorpusEntry& entry) {
  const Domain domain = support::read_corpus_file(corpus + "/" + entry.file);
  return encloses_area(entry) ? domain : framed(domain);
}

/// Two points on a line, and coordinates of 1e141.
bool is_beyond_limits(const CorpusEntry& entry) {
  return entry.file == "issue-threads/cdt-154-1.json" || entry.file == "issue-threads/qhull-166.json";
}

/// Calls f for each geometry that can be meshed, with what clean() makes of it.
void for_each_meshable(const std::function<void(const CorpusEntry&, const Domain&)>& f) {
  const auto shared = support::shared_dir();
  if (!shared) return;
  int count = 0;
  for (const CorpusEntry& entry : support::corpus_entries(*shared + "/corpus")) {
    if (entry.kind == "invalid-crossing" || is_beyond_limits(entry)) continue;
    INFO(entry.file);
    f(entry, clean(domain_of(*shared + "/corpus", entry)).domain);
    ++count;
  }
  CHECK(count == 189);
}

void check_mesh(const Mesh& mesh, const Domain& domain) {
  constexpr std::size_t most_segments = 2500;  // the oracle's time is their number times that of the edges
  for (const auto& problem : oracle::problems_of(mesh)) FAIL_CHECK(problem);
  if (domain.segments.size() > most_segments) return;
  const double tolerance = 0x1p-49 * box_of(domain.points).largest();
  for (const auto& problem : oracle::problems_of_cover(mesh, domain, tolerance)) FAIL_CHECK(problem);
}

bool has_area_of(const CorpusEntry& entry, const Mesh& mesh) {
  const Box box = box_of(mesh.points);
  const double rounding = 1e-15 * box.diameter() * box.largest();  // vertices on slanted segments
  return !encloses_area(entry) || std::abs(oracle::area_of(mesh) - entry.area) < 1e-5 * entry.area + rounding;
}

Mesh triangulated(const Domain& domain) {
  const Triangulation t = triangulate(domain);
  for (const auto& problem : check(t, {.is_delaunay = true})) FAIL_CHECK(problem);
  std::vector<int> labels;
  for (const Segment& s : domain.segments) labels.push_back(s.label);
  const Mesh mesh = to_mesh(t, labels).mesh;
  check_mesh(mesh, domain);
  return mesh;
}

void check_generated(const CorpusEntry& entry, const Domain& domain, const MetricField& field) {
  const Mesh mesh = generate(domain, field).mesh;
  check_mesh(mesh, domain);
  CHECK(has_area_of(entry, mesh));
}

}  // namespace

TEST_CASE("clean agrees with the exact classification of the corpus", "[mesher][domain][shared]") {
  const auto shared = support::shared_dir();
  if (!shared) return;
  const auto entries = support::corpus_entries(*shared + "/corpus");
  CHECK(entries.size() == 246);
  for (const CorpusEntry& entry : entries) {
    INFO(entry.file);
    const Domain read = support::read_corpus_file(*shared + "/corpus/" + entry.file);
    CHECK(static_cast<int>(read.points.size()) == entry.points);
    CHECK(static_cast<int>(read.segments.size()) == entry.segments);
    const Domain domain = domain_of(*shared + "/corpus", entry);
    if (entry.kind == "invalid-crossing" || is_beyond_limits(entry)) {
      CHECK_THROWS_AS(clean(domain), InputError);
      continue;
    }
    const Domain cleaned = clean(domain).domain;
    CHECK(static_cast<int>(domain.points.size() - cleaned.points.size()) == entry.duplicate_points);
    CHECK(clean(cleaned).domain.segments.size() == cleaned.segments.size());
  }
}

TEST_CASE("constrained Delaunay triangulations of the corpus are as another program makes them",
          "[mesher][triangulation][shared][slow]") {
  for_each_meshable([](const CorpusEntry& entry, const Domain& domain) {
    const Mesh mesh = triangulated(domain);
    CHECK(has_area_of(entry, mesh));
    if (encloses_area(entry)) CHECK(mesh.num_triangles() == entry.triangles);
  });
}

TEST_CASE("small geometries of the corpus are meshed in a layer's metric", "[mesher][generate][shared]") {
  for_each_meshable([](const CorpusEntry& entry, const Domain& domain) {
    if (domain.segments.size() < 12) check_generated(entry, domain, layer_in(box_of(domain.points)));
  });
}

TEST_CASE("the corpus is meshed with coarse and fine uniform sizes and in a layer's metric",
          "[mesher][generate][shared][slow]") {
  for_each_meshable([](const CorpusEntry& entry, const Domain& domain) {
    const Box box = box_of(domain.points);
    for (const double share : {0.3, 0.05})
      check_generated(entry, domain, ConstantField(Metric::isotropic(share * box.diameter())));
    check_generated(entry, domain, layer_in(box));
  });
}
