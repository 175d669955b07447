#include "mesher/triangulation/face_walks.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "tests/support/domains.h"

using namespace parmesan;

namespace {

struct DiagonalSquare {
  double low, high;  // of both coordinates
  bool holds(const Point& p) const { return std::min(p.x, p.y) > low && std::max(p.x, p.y) < high; }
};

const std::vector<DiagonalSquare> kDiagonalSquares{{0, 20}, {2, 8}, {3, 5}, {10, 18}, {12, 14}, {30, 40}};

Domain diagonal_squares() {
  Domain domain;
  for (const auto& [low, high] : kDiagonalSquares)
    support::add_polygon(domain, {{low, low}, {high, low}, {high, high}, {low, high}}, 0);
  return domain;
}

}  // namespace

TEST_CASE("A walk through the faces comes into each of them across the borders around it", "[mesher][triangulation]") {
  const Faces faces(diagonal_squares());
  REQUIRE(faces.count() == 7);
  CHECK(faces.num_segments() == 24);
  const std::vector<FacePoint> points = faces.points_inside();
  std::vector<char> is_inside(kDiagonalSquares.size(), 0);
  std::vector<int> visits(7, 0);
  walk_faces(
      faces,
      [&](int s) {
        char& inside = is_inside[at(s / 4)];
        inside = inside == 0 ? 1 : 0;
      },
      [&](int face) {
        ++visits[at(face)];
        for (std::size_t i = 0; i < kDiagonalSquares.size(); ++i)
          CHECK((is_inside[i] != 0) == (face != 0 && kDiagonalSquares[i].holds(points[at(face)].place)));
      });
  CHECK(visits == std::vector<int>(7, 1));
  CHECK(is_inside == std::vector<char>(kDiagonalSquares.size(), 0));
}

TEST_CASE("The layer of a face is the number of borders around it that count", "[mesher][triangulation]") {
  const Faces faces(diagonal_squares());
  const std::vector<FacePoint> points = faces.points_inside();
  const auto skipped = GENERATE(-1, 0, 1, 5);  // a square whose sides do not count
  const std::vector<int> layers = layers_of(faces, [&](int s) { return s / 4 != skipped; });
  REQUIRE(layers.size() == 7);
  CHECK(layers[0] == 0);
  for (int face = 1; face < faces.count(); ++face) {
    int around = 0;
    for (int i = 0; i < 6; ++i) around += i != skipped && kDiagonalSquares[at(i)].holds(points[at(face)].place) ? 1 : 0;
    CHECK(layers[at(face)] == around);
  }
}
