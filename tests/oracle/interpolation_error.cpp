#include "tests/oracle/interpolation_error.h"

#include <array>
#include <cmath>

namespace parmesan::oracle {
namespace {

struct Node {
  double at, weight;
};
// Gauss's rule on [0, 1], exact to degree 7.
constexpr std::array<Node, 4> gauss{{{0.069431844202973714, 0.17392742256872693},
                                     {0.33000947820757187, 0.32607257743127307},
                                     {0.66999052179242813, 0.32607257743127307},
                                     {0.93056815579702629, 0.17392742256872693}}};

}  // namespace

double squared_interpolation_error(const Point& a, const Point& b, const Point& c, const ScalarFunction& u) {
  const double jacobian = std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
  const double ua = u(a), ub = u(b), uc = u(c);
  double sum = 0.0;
  for (const Node& s : gauss) {
    for (const Node& t : gauss) {
      const double lb = s.at * (1.0 - t.at), lc = s.at * t.at, la = 1.0 - s.at;
      const Point p{la * a.x + lb * b.x + lc * c.x, la * a.y + lb * b.y + lc * c.y};
      const double error = u(p) - (la * ua + lb * ub + lc * uc);
      sum += s.weight * t.weight * s.at * error * error;
    }
  }
  return jacobian * sum;
}

double squared_interpolation_error(const Mesh& mesh, const ScalarFunction& u) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum +=
        squared_interpolation_error(mesh.points[static_cast<std::size_t>(a)], mesh.points[static_cast<std::size_t>(b)],
                                    mesh.points[static_cast<std::size_t>(c)], u);
  }
  return sum;
}

}  // namespace parmesan::oracle
