#include "tools/thesis/in_circle_forms.h"

#include <ctime>
#include <random>

#include "mesher/geometry/predicates.h"
#include "tools/thesis/experiment.h"

namespace parmesan::thesis {
namespace {

struct Operations {
  int multiplications = 0;
  int additions = 0;
  int divisions = 0;
};
thread_local Operations operations;

/// A number that counts what is done with it. A product with 2 counts, as in the thesis.
struct Counted {
  double value;
  explicit Counted(double v) : value(v) {}
  friend Counted operator+(Counted a, Counted b) { return ++operations.additions, Counted(a.value + b.value); }
  friend Counted operator-(Counted a, Counted b) { return ++operations.additions, Counted(a.value - b.value); }
  friend Counted operator*(Counted a, Counted b) { return ++operations.multiplications, Counted(a.value * b.value); }
  friend Counted operator/(Counted a, Counted b) { return ++operations.divisions, Counted(a.value / b.value); }
  friend bool operator<(Counted a, Counted b) { return a.value < b.value; }
  friend bool operator>(Counted a, Counted b) { return a.value > b.value; }
};

/// An edge from a to b, i to its left, j to its right.
struct Quadrilateral {
  Point a, b, i, j;
};

std::vector<Quadrilateral> random_quadrilaterals(int n) {
  std::mt19937 engine(7);
  const auto draw = [&engine] { return static_cast<double>(engine()) / 4294967296.0; };
  std::vector<Quadrilateral> all;
  while (static_cast<int>(all.size()) < n) {
    const Quadrilateral q{{draw(), draw()}, {draw(), draw()}, {draw(), draw()}, {draw(), draw()}};
    if (orient2d(q.a, q.b, q.i) > 0.0 && orient2d(q.a, q.b, q.j) < 0.0) all.push_back(q);
  }
  return all;
}

template <class Number>
InCirclePoint<Number> as(const Point& p) {
  return {Number(p.x), Number(p.y)};
}

/// Each form is a functor, so that it is inlined where it is timed.
struct ByCenter {
  template <class P>
  bool operator()(const P& a, const P& b, const P& i, const P& j) const {
    return in_circle_by_center(a, b, i, j);
  }
};
struct ByLifting {
  template <class P>
  bool operator()(const P& a, const P& b, const P& i, const P& j) const {
    return in_circle_by_lifting(a, b, i, j);
  }
};
struct ByAngles {
  template <class P>
  bool operator()(const P& a, const P& b, const P& i, const P& j) const {
    return in_circle_by_angles(a, b, i, j);
  }
};

struct Trial {
  Operations operations;
  double nanoseconds = 0.0;
  int wrong = 0;
};

template <class Form>
Trial trial(const std::vector<Quadrilateral>& all, Form form, int rounds) {
  Trial result;
  operations = {};
  const Quadrilateral& first = all.front();
  form(as<Counted>(first.a), as<Counted>(first.b), as<Counted>(first.i), as<Counted>(first.j));
  result.operations = operations;
  std::int64_t inside = 0;
  const std::clock_t start = std::clock();
  for (int round = 0; round < rounds; ++round)
    for (const Quadrilateral& q : all)
      inside += form(as<double>(q.a), as<double>(q.b), as<double>(q.i), as<double>(q.j)) ? 1 : 0;
  const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  result.nanoseconds = 1e9 * seconds / (static_cast<double>(all.size()) * rounds);
  std::int64_t expected = 0;
  for (const Quadrilateral& q : all) {
    const bool exact = incircle(q.a, q.b, q.i, q.j) > 0.0;
    expected += exact ? 1 : 0;
    if (form(as<double>(q.a), as<double>(q.b), as<double>(q.i), as<double>(q.j)) != exact) ++result.wrong;
  }
  if (inside != expected * rounds && result.wrong == 0) result.wrong = 1;
  return result;
}

}  // namespace

Item in_circle_forms(const Setting& setting) {
  Item item("in_circle", "2.3.2: the three forms of the in-circle test");
  const auto all = random_quadrilaterals(10000);
  const int rounds = setting.quick ? 20 : 2000;
  const Trial center = trial(all, ByCenter{}, rounds);
  const Trial lifting = trial(all, ByLifting{}, rounds);
  const Trial angles = trial(all, ByAngles{}, rounds);
  const auto check = [&](const char* name, const Trial& t, const Operations& printed) {
    const auto same = [&](const char* what, int of_thesis, int ours) {
      item.add(std::string(name) + ": " + what, of_thesis, ours, "",
               {.min = static_cast<double>(of_thesis), .max = static_cast<double>(of_thesis)});
    };
    same("multiplications", printed.multiplications, t.operations.multiplications);
    same("additions", printed.additions, t.operations.additions);
    same("divisions", printed.divisions, t.operations.divisions);
    item.add(std::string(name) + ": wrong answers in 10 000", nullptr, t.wrong, "", {.max = 0.0});
  };
  check("circle", center, {15, 19, 2});
  check("convex hull", lifting, {15, 14, 0});
  check("angles", angles, {10, 13, 0});
  item.add_table("Time of one test, in a loop over 10 000 random quadrilaterals", {"form", "ns", "of the angle form"},
                 {{"circle", center.nanoseconds, center.nanoseconds / angles.nanoseconds},
                  {"convex hull", lifting.nanoseconds, lifting.nanoseconds / angles.nanoseconds},
                  {"angles", angles.nanoseconds, 1.0}});
  item.add_note("The thesis ranks them angles, convex hull, circle by speed and gives no times.");
  return item;
}

}  // namespace parmesan::thesis
