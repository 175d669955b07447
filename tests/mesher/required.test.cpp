#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>

#include "mesher/errors.h"
#include "mesher/generate.h"
#include "mesher/generate_around.h"
#include "mesher/geometry/clean.h"
#include "mesher/geometry/domain_of_mesh.h"
#include "mesher/index.h"
#include "mesher/io/mesh_file.h"
#include "mesher/triangulation/refine.h"
#include "mesher/validate.h"
#include "tests/oracle/domain_cover.h"
#include "tests/oracle/mesh_checker.h"
#include "tests/support/curved_domains.h"
#include "tests/support/domains.h"
#include "tests/support/meshes.h"
#include "tests/support/temporary_folder.h"

using namespace parmesan;

namespace {

using Corners = std::array<Point, 3>;

Corners corners_of(const Mesh& mesh, int t) {
  Corners corners;
  for (std::size_t k = 0; k < 3; ++k) corners[k] = mesh.points[at(mesh.triangles[at(t)][k])];
  return corners;
}

std::vector<std::pair<Corners, int>> required_triangles(const Mesh& mesh) {
  std::vector<std::pair<Corners, int>> result;
  for (const int t : mesh.required.triangles) result.emplace_back(corners_of(mesh, t), mesh.regions[at(t)]);
  return result;
}

/// The unit square, its lower left part beyond a slanted border region 3.
Domain two_regions() {
  Domain domain = support::unit_square();
  domain.points.insert(domain.points.end(), {{0.3, 0.0}, {0.45, 0.55}, {0.0, 0.7}});
  domain.segments.insert(domain.segments.end(), {{4, 5, 8}, {5, 6, 9}});
  domain.regions = {{{0.1, 0.1}, 3}, {{0.9, 0.9}, 4}};
  domain.region_names = {{3, "kept"}};
  return domain;
}

Mesh uniform(const Domain& domain, double h) { return generate(domain, ConstantField(Metric::isotropic(h))).mesh; }

void check_valid(const Mesh& mesh, double area) {
  CHECK_NOTHROW(validate(mesh));
  CHECK(oracle::problems_of(mesh) == std::vector<std::string>{});
  CHECK(oracle::area_of(mesh) == Approx(area).epsilon(1e-12));
}

/// The count of misfits for a reason, 0 where it is not named.
std::int64_t count_of(const std::vector<Misfits>& misfits, MisfitReason reason) {
  for (const Misfits& m : misfits)
    if (m.reason == reason) return m.count;
  return 0;
}

int num_edges_of(const Mesh& mesh, int label) {
  return static_cast<int>(std::count(mesh.labels.begin(), mesh.labels.end(), label));
}

}  // namespace

TEST_CASE("a required segment stays one edge, and the diagnosis says what that costs", "[mesher][required]") {
  Domain domain = support::unit_square();
  domain.points.insert(domain.points.end(), {{0.2, 0.3}, {0.7, 0.4}, {0.5, 0.7}});
  domain.segments.push_back({4, 5, 7, {}, true});
  domain.required_points = {6};
  const Schedule schedule = GENERATE(Schedule::Fast, Schedule::Thesis);
  const double h = GENERATE(0.05, 0.3, 2.0);
  GenerateOptions options{.schedule = schedule};
  options.particles.max_picks = 50;
  const GenerateResult result = generate(domain, ConstantField(Metric::isotropic(h)), options);
  check_valid(result.mesh, 1.0);
  CHECK(oracle::problems_of_cover(result.mesh, domain) == std::vector<std::string>{});
  CHECK(num_edges_of(result.mesh, 7) == 1);
  REQUIRE(result.mesh.required.edges.size() == 1);
  CHECK(result.mesh.labels[at(result.mesh.required.edges[0])] == 7);
  REQUIRE(result.mesh.required.vertices.size() == 1);
  CHECK(result.mesh.points[at(result.mesh.required.vertices[0])] == Point{0.5, 0.7});
  CHECK(count_of(result.report.diagnosis.long_edges, MisfitReason::Required) == (h < 1.0 ? 1 : 0));  // 0.51 long
}

TEST_CASE("a segment along a curve cannot stay one edge", "[mesher][required][curves][errors]") {
  Domain domain = support::half_disc();
  domain.segments[0].required = true;
  CHECK_THROWS_AS(generate(domain, ConstantField(Metric::isotropic(0.5))), GeometryError);
}

TEST_CASE("a previous mesh that cut a required segment is no start", "[mesher][required]") {
  Domain domain = support::unit_square();
  domain.points.insert(domain.points.end(), {{0.2, 0.3}, {0.7, 0.4}});
  domain.segments.push_back({4, 5, 7});
  const Mesh cut = uniform(domain, 0.1);
  domain.segments.back().required = true;
  const GenerateResult result = generate(domain, ConstantField(Metric::isotropic(0.1)), {}, cut);
  CHECK(result.report.start == Start::Scratch);
  CHECK(num_edges_of(result.mesh, 7) == 1);
}

TEST_CASE("red refinement leaves required edges whole", "[mesher][required]") {
  Mesh mesh = support::rectangle_mesh(3, 3);
  mesh.required.edges = {1, 7};
  mesh.required.vertices = {5};
  const Mesh fine = refine_red(mesh);
  check_valid(fine, 1.0);
  CHECK(fine.num_edges() == 2 * mesh.num_edges() - 2);
  CHECK(fine.required.vertices == mesh.required.vertices);
  REQUIRE(fine.required.edges.size() == 2);
  for (std::size_t i = 0; i < 2; ++i)
    CHECK(fine.edges[at(fine.required.edges[i])] == mesh.edges[at(mesh.required.edges[i])]);
}

TEST_CASE("what a mesh requires is required of its domain", "[mesher][required]") {
  Mesh mesh = support::rectangle_mesh(4, 4);
  mesh.required.edges = {1};      // from (1/4, 0) to (1/2, 0)
  mesh.required.vertices = {12};  // the middle
  const Domain domain = domain_of(mesh);
  CHECK(domain.segments.size() == 4 + 2);  // the bottom in three
  const auto required =
      std::find_if(domain.segments.begin(), domain.segments.end(), [](const Segment& s) { return s.required; });
  REQUIRE(required != domain.segments.end());
  CHECK(domain.points[at(required->a)] == Point{0.25, 0.0});
  CHECK(domain.points[at(required->b)] == Point{0.5, 0.0});
  REQUIRE(domain.required_points.size() == 1);
  CHECK(domain.points[at(domain.required_points[0])] == Point{0.5, 0.5});
}

TEST_CASE("required parts survive files of Medit and Gmsh", "[mesher][required][io]") {
  const support::TemporaryFolder folder;
  Mesh mesh = support::rectangle_mesh(3, 2);
  mesh.required = {{0, 4, 11}, {2}, {1, 5}};
  const char* name = GENERATE("a.mesh", "a.meshb", "a.msh");
  write_mesh_file(folder / name, mesh);
  CHECK(read_mesh_file(folder / name).required == mesh.required);
}

TEST_CASE("required triangles stay bit for bit while the rest is meshed anew", "[mesher][required]") {
  const Mesh first = with_required_regions(uniform(two_regions(), 0.13), {3});
  REQUIRE(first.required.triangles.size() > 20);
  const double h = GENERATE(0.03, 0.12, 1.0);
  const CallableField field([h](const Point& p) { return Metric::from_sizes(h, 2.0 * h, p.x); });
  const GenerateResult result = generate_around(first, field);
  check_valid(result.mesh, 1.0);
  CHECK(required_triangles(result.mesh) == required_triangles(first));
  CHECK(result.metrics.size() == result.mesh.points.size());
  CHECK(result.mesh.num_triangles() != first.num_triangles());
  for (const int label : {8, 9}) CHECK(num_edges_of(result.mesh, label) == num_edges_of(first, label));
  const std::set<int> regions(result.mesh.regions.begin(), result.mesh.regions.end());
  CHECK(regions == std::set<int>{3, 4});
  const Diagnosis& diagnosis = result.report.diagnosis;
  CHECK(diagnosis.num_triangles == result.mesh.num_triangles());
  if (h < 0.1) CHECK(count_of(diagnosis.long_edges, MisfitReason::Required) > 20);
  if (h > 0.5) CHECK(count_of(diagnosis.short_edges, MisfitReason::Required) > 20);
  SECTION("again and again") {
    const GenerateResult again = generate_around(result.mesh, field);
    check_valid(again.mesh, 1.0);
    CHECK(required_triangles(again.mesh) == required_triangles(first));
    if (h < 0.1) CHECK(again.report.start == Start::PreviousMesh);
  }
}

TEST_CASE("labels and regions of any number are kept around required triangles", "[mesher][required]") {
  Mesh first = uniform(two_regions(), 0.13);
  // All labels from -1 on, so that the one of the cut is none of them; and regions that are not in order.
  for (int e = 0; e < first.num_edges(); ++e) first.labels[at(e)] = e - 1;
  for (int t = 0; t < first.num_triangles(); ++t) first.regions[at(t)] = (7 * t) % first.num_triangles();
  first = with_required_regions(std::move(first), {5, 3, 8, 3});
  REQUIRE(first.required.triangles.size() == 3);
  const GenerateResult result = generate_around(first, ConstantField(Metric::isotropic(0.13)));
  check_valid(result.mesh, 1.0);
  CHECK(required_triangles(result.mesh) == required_triangles(first));
  CHECK(std::set<int>(result.mesh.labels.begin(), result.mesh.labels.end()) ==
        std::set<int>(first.labels.begin(), first.labels.end()));
}

TEST_CASE("any triangles can be required, also where cracks end", "[mesher][required]") {
  Domain domain = support::unit_square();
  domain.points.insert(domain.points.end(), {{0.2, 0.5}, {0.8, 0.5}});
  domain.segments.push_back({4, 5, 7, 8});
  Mesh first = uniform(domain, 0.1);
  int stride = GENERATE(2, 7);
  for (int t = 0; t < first.num_triangles(); t += stride) first.required.triangles.push_back(t);
  const GenerateResult result = generate_around(first, ConstantField(Metric::isotropic(0.05)));
  check_valid(result.mesh, 1.0);
  CHECK(oracle::problems_of_cover(result.mesh, domain) == std::vector<std::string>{});
  CHECK(required_triangles(result.mesh) == required_triangles(first));
}

TEST_CASE("a mesh whose triangles are all required stays", "[mesher][required]") {
  const Mesh first = with_required_regions(uniform(two_regions(), 0.2), {3, 4});
  const GenerateResult result = generate_around(first, ConstantField(Metric::isotropic(0.05)));
  CHECK(result.mesh.points == first.points);
  CHECK(result.mesh.triangles == first.triangles);
  CHECK(count_of(result.report.diagnosis.long_edges, MisfitReason::Required) > 0);
}

TEST_CASE("numbers of required parts must be in range", "[mesher][required][errors]") {
  Mesh mesh = support::rectangle_mesh(2, 2);
  mesh.required.triangles = {8};
  CHECK_THROWS_AS(validate(mesh), GeometryError);
  Domain domain = support::unit_square();
  domain.required_points = {4};
  CHECK_THROWS_AS(clean(domain), GeometryError);
}

TEST_CASE("parts that touch in a point keep it as one vertex when one of them is required", "[mesher][required]") {
  Mesh mesh;
  mesh.points = {{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}};
  mesh.triangles = {{0, 1, 2}, {2, 3, 4}, {2, 4, 5}};
  mesh.regions = {1, 2, 2};
  mesh.edges = {{0, 1}, {1, 2}, {2, 0}, {2, 3}, {3, 4}, {4, 5}, {5, 2}};
  mesh.labels = {1, 2, 3, 4, 5, 6, 7};
  const Mesh around = generate_around(with_required_regions(mesh, {2}), ConstantField(Metric::isotropic(0.5))).mesh;
  std::set<std::pair<double, double>> places;
  for (const Point& p : around.points) places.insert({p.x, p.y});
  CHECK(places.size() == around.points.size());
}
