#include "tests/support/hard_polygons.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace parmesan::support {
namespace {

using Ring = std::vector<Point>;

class Maker {
 public:
  explicit Maker(std::uint32_t number) : random_(number) {}

  HardPolygon make(std::uint32_t kind) {
    switch (kind % 7) {
      case 0:
        return {"random simple polygon", placed({simple()})};
      case 1:
        return {"Koch curve", placed({koch()})};
      case 2:
        return {"comb", comb()};
      case 3:
        return {"star", star()};
      case 4:
        return {"grid", grid()};
      case 5:
        return {"nearly straight chain", chain()};
      default:
        return {"nested rings", placed(rings())};
    }
  }

 private:
  std::mt19937 random_;

  int whole(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  double real(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

  static Domain domain_of(const std::vector<Ring>& rings) {
    Domain domain;
    domain.inside = Inside::EvenOdd;
    for (const Ring& ring : rings) {
      const int first = static_cast<int>(domain.points.size());
      const int n = static_cast<int>(ring.size());
      domain.points.insert(domain.points.end(), ring.begin(), ring.end());
      for (int i = 0; i < n; ++i) domain.segments.push_back({first + i, first + (i + 1) % n, first + i + 1});
    }
    return domain;
  }

  /// By a power of two, so that nothing is rounded.
  Domain scaled(Domain domain) {
    const double scale = std::ldexp(1.0, whole(-60, 60));
    for (Point& p : domain.points) p = {scale * p.x, scale * p.y};
    return domain;
  }

  Domain placed(std::vector<Ring> rings) {
    const double angle = real(0.0, 2.0 * std::numbers::pi);
    const Point offset{real(-10.0, 10.0), real(-10.0, 10.0)};
    for (Ring& ring : rings) {
      for (Point& p : ring) {
        p = {offset.x + std::cos(angle) * p.x - std::sin(angle) * p.y,
             offset.y + std::sin(angle) * p.x + std::cos(angle) * p.y};
      }
    }
    return scaled(domain_of(rings));
  }

  /// Random corners, untangled: as long as two sides cross, the part between them is reversed.
  Ring simple() {
    Ring ring(static_cast<std::size_t>(whole(4, 60)));
    for (Point& p : ring) p = {real(0.0, 1.0), real(0.0, 1.0)};
    const auto crosses = [&ring](std::size_t i, std::size_t j) {
      const Point& a = ring[i];
      const Point& b = ring[i + 1];
      const Point& c = ring[j];
      const Point& d = ring[(j + 1) % ring.size()];
      return doubled_area(a, b, c) * doubled_area(a, b, d) < 0.0 && doubled_area(c, d, a) * doubled_area(c, d, b) < 0.0;
    };
    for (bool tangled = true; tangled;) {
      tangled = false;
      for (std::size_t i = 0; i + 2 < ring.size(); ++i) {
        for (std::size_t j = i + 2; j < ring.size(); ++j) {
          if (!crosses(i, j)) continue;
          std::reverse(ring.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                       ring.begin() + static_cast<std::ptrdiff_t>(j) + 1);
          tangled = true;
        }
      }
    }
    return ring;
  }

  Ring koch() {
    Ring ring{{0, 0}, {0.5, std::sqrt(0.75)}, {1, 0}};
    for (int depth = whole(0, 4); depth > 0; --depth) {
      Ring finer;
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point& a = ring[i];
        const Point& b = ring[(i + 1) % ring.size()];
        const Vector third = (1.0 / 3.0) * (b - a);
        const Point c = a + third;
        finer.insert(
            finer.end(),
            {a, c, c + Vector{0.5 * third.x - std::sqrt(0.75) * third.y, std::sqrt(0.75) * third.x + 0.5 * third.y},
             c + third});
      }
      ring = finer;
    }
    return ring;
  }

  Domain comb() {
    const double gap = std::ldexp(1.0, -whole(1, 40));
    Ring ring{{0, 0}};
    double x = 0.0;
    for (int tooth = whole(2, 12); tooth > 0; --tooth) {
      ring.insert(ring.end(), {{x, 1.0}, {x + 0.25, 1.0}, {x + 0.25, 0.125}, {x + 0.25 + gap, 0.125}});
      x += 0.25 + gap;
    }
    ring.insert(ring.end(), {{x, 1.0}, {x + 0.25, 1.0}, {x + 0.25, 0.0}});
    return scaled(domain_of({ring}));
  }

  /// Spikes of length 1 and width 2^-k up from a bar.
  Domain star() {
    const double width = std::ldexp(1.0, -whole(1, 40));
    Ring ring{{0, 0}};
    double x = 0.0;
    for (int tip = whole(1, 10); tip > 0; --tip) {
      ring.insert(ring.end(), {{x, 1.0}, {x + width, 2.0}, {x + 2.0 * width, 1.0}});
      x += 0.25 + 2.0 * width;
    }
    ring.insert(ring.end(), {{x, 1.0}, {x, 0.0}});
    return scaled(domain_of({ring}));
  }

  Domain grid() {
    const int n = whole(1, 12);
    const double size = n + 1.0;
    Domain domain = domain_of({{{0, 0}, {size, 0}, {size, size}, {0, size}}});
    for (int i = 1; i <= n; ++i)
      for (int j = 1; j <= n; ++j) domain.points.push_back({static_cast<double>(i), static_cast<double>(j)});
    return scaled(domain);
  }

  /// Under a parabola so flat that it bends by units in the last place between its points.
  Domain chain() {
    const int n = whole(3, 60);
    const double bend = std::ldexp(1.0, -whole(20, 50));
    Ring ring{{0, -1}};
    for (int i = 0; i <= n; ++i) {
      const double x = static_cast<double>(i) / 64.0;
      ring.push_back({x, 0.25 * x + bend * x * (n / 64.0 - x)});
    }
    ring.push_back({n / 64.0, -1});
    return scaled(domain_of({ring}));
  }

  std::vector<Ring> rings() {
    std::vector<Ring> all;
    const int corners = whole(3, 9);
    for (int depth = whole(1, 50); depth > 0; --depth) {
      Ring& ring = all.emplace_back();
      for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / corners;
        ring.push_back({depth * std::cos(angle), depth * std::sin(angle)});
      }
    }
    return all;
  }
};

}  // namespace

HardPolygon hard_polygon(std::uint32_t number) { return Maker(number).make(number); }

}  // namespace parmesan::support
