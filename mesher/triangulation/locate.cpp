#include "mesher/triangulation/locate.h"

#include <array>
#include <optional>

#include "mesher/triangulation/side_of.h"

namespace parmesan {
namespace {

/// For p on the line of e: strictly between its ends.
bool is_between_ends(const Triangulation& t, EdgeId e, const Point& p) {
  const Point& a = t.point(t.org(e));
  const Point& b = t.point(t.dest(e));
  if (a.x != b.x) return a.x < b.x ? a.x < p.x && p.x < b.x : b.x < p.x && p.x < a.x;
  return a.y < b.y ? a.y < p.y && p.y < b.y : b.y < p.y && p.y < a.y;
}

/// For p on the line of e: on an end point or between them; nothing otherwise.
std::optional<Location> hit_on_line(const Triangulation& t, EdgeId e, const Point& p) {
  if (p == t.point(t.org(e))) return Location{Hit::Vertex, e};
  if (p == t.point(t.dest(e))) return Location{Hit::Vertex, sym(e)};
  if (is_between_ends(t, e, p)) return Location{Hit::Edge, t.is_inside_left(e) ? e : sym(e)};
  return std::nullopt;
}

/// One walk. e has a triangle on its left and p on its left or on it.
class Walk {
 public:
  Walk(const Triangulation& t, const Point& p) : t_(t), p_(p) {}

  /// Nothing when the walk ends before a constrained boundary, or after too many steps.
  std::optional<Location> from(EdgeId start);

 private:
  enum class Step { Stays, Blocked, Moves, Ends };

  bool enter(EdgeId start);
  Step try_edge(EdgeId f);

  const Triangulation& t_;
  const Point& p_;
  EdgeId e_;
  double side_ = 0.0;  // of p to e_
  std::optional<Location> result_;
};

// Of the three edges of a triangle at least one has p on its left.
bool Walk::enter(EdgeId start) {
  e_ = t_.is_inside_left(start) ? start : sym(start);
  if (!t_.is_inside_left(e_)) return false;
  side_ = side_of(t_, e_, p_);
  if (side_ < 0.0 && t_.is_inside_right(e_)) {
    e_ = sym(e_);
    side_ = -side_;
  }
  while (side_ < 0.0) {
    e_ = t_.lnext(e_);
    side_ = side_of(t_, e_, p_);
  }
  if (side_ == 0.0) result_ = hit_on_line(t_, e_, p_);
  return true;
}

// f has the triangle on its right. The walk crosses f unless p lies strictly on the triangle's side.
Walk::Step Walk::try_edge(EdgeId f) {
  const double side = side_of(t_, f, p_);
  if (side < 0.0) return Step::Stays;
  if (side == 0.0) {
    result_ = hit_on_line(t_, f, p_);
    if (result_) return Step::Ends;
  }
  if (!t_.is_inside_left(f)) {
    if (side == 0.0 || t_.is_constrained(f)) return Step::Blocked;
    result_ = Location{Hit::Outside, sym(f)};
    return Step::Ends;
  }
  e_ = f;
  side_ = side;
  return Step::Moves;
}

// The automaton's memory is which edge to test first: after a step over onext(e) it is dprev(e),
// and the other way round (states s1 and s2 of Fig. 2.8).
std::optional<Location> Walk::from(EdgeId start) {
  constexpr int steps_before_random = 500;
  if (!enter(start) || result_) return result_;
  const int limit = 3 * steps_before_random + t_.size();
  std::uint32_t random = 1;
  bool onext_first = true;
  for (int k = 0; k < limit; ++k) {
    if (k > steps_before_random) {
      random = 1664525U * random + 1013904223U;
      onext_first = (random >> 31U) != 0;
    }
    const EdgeId e = e_;
    Step step = try_edge(onext_first ? t_.onext(e) : t_.dprev(e));
    if (step == Step::Moves) {
      onext_first = !onext_first;
      continue;
    }
    bool blocked = step == Step::Blocked;
    if (step != Step::Ends) step = try_edge(onext_first ? t_.dprev(e) : t_.onext(e));
    if (step == Step::Ends) return result_;
    if (step == Step::Moves) continue;
    blocked = blocked || step == Step::Blocked;
    if (blocked) return std::nullopt;
    return Location{side_ == 0.0 ? Hit::Edge : Hit::Face, e_};
  }
  return std::nullopt;
}

/// Edges spread over the array, to start again from the one that begins nearest to p.
EdgeId nearest_of_sample(const Triangulation& t, const Point& p) {
  constexpr std::int32_t samples = 64;
  EdgeId nearest = no_edge;
  double smallest = 0.0;
  for (std::int32_t k = 0; k < samples; ++k) {
    const auto q = static_cast<std::int32_t>(std::int64_t{t.size()} * k / samples);
    if (!t.is_alive(q)) continue;
    const EdgeId e{4 * q};
    const double d = squared_norm(t.point(t.org(e)) - p);
    if (nearest != no_edge && d >= smallest) continue;
    nearest = e;
    smallest = d;
  }
  return nearest;
}

std::optional<Location> hit_in_triangle(const Triangulation& t, EdgeId e, const Point& p) {
  std::array<EdgeId, 3> edges = {e, t.lnext(e), t.lprev(e)};
  for (const EdgeId f : edges) {
    const double side = side_of(t, f, p);
    if (side < 0.0) return std::nullopt;
    if (side > 0.0) continue;
    if (const auto hit = hit_on_line(t, f, p)) return hit;
  }
  return Location{Hit::Face, e};
}

}  // namespace

EdgeId some_inside_edge(const Triangulation& t) {
  for (std::int32_t q = 0; q < t.size(); ++q) {
    const EdgeId e{4 * q};
    if (!t.is_alive(q)) continue;
    if (t.is_inside_left(e)) return e;
    if (t.is_inside_right(e)) return sym(e);
  }
  return no_edge;
}

Location locate_exhaustively(const Triangulation& t, const Point& p) {
  Location outside;
  for (std::int32_t index = 0; index < 4 * t.size(); index += 2) {
    const EdgeId e{index};
    if (!t.is_alive(undirected(e)) || !t.is_inside_left(e)) continue;
    if (!t.is_inside_right(e)) {
      const bool sees = side_of(t, e, p) < 0.0;
      if (sees || outside.edge == no_edge) outside.edge = e;
    }
    if (e.index > t.lnext(e).index || e.index > t.lprev(e).index) continue;
    if (const auto hit = hit_in_triangle(t, e, p)) return *hit;
  }
  return outside;
}

Location locate(const Triangulation& t, const Point& p, EdgeId start) {
  Walk walk(t, p);
  if (const auto found = walk.from(start)) return *found;
  const EdgeId again = nearest_of_sample(t, p);
  if (again != no_edge) {
    Walk second(t, p);
    if (const auto found = second.from(again)) return *found;
  }
  return locate_exhaustively(t, p);
}

}  // namespace parmesan
