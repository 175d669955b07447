#include "tools/thesis/counted_walks.h"

#include "mesher/geometry/predicates.h"

namespace parmesan::thesis {
namespace {

/// The procedures that walks are made of; each call is counted.
class Counter {
 public:
  Counter(const Triangulation& t, const Point& p) : t_(t), p_(p) {}

  bool is_right_of(EdgeId e) {
    ++counts_.right_of;
    return orient2d(t_.point(t_.org(e)), t_.point(t_.dest(e)), p_) < 0.0;
  }
  bool is_org(EdgeId e) {
    ++counts_.org;
    ++counts_.equal;
    return t_.point(t_.org(e)) == p_;
  }
  bool is_dest(EdgeId e) {
    ++counts_.dest;
    ++counts_.equal;
    return t_.point(t_.dest(e)) == p_;
  }
  EdgeId onext(EdgeId e) {
    ++counts_.onext;
    return t_.onext(e);
  }
  EdgeId dprev(EdgeId e) {
    ++counts_.dprev;
    return t_.dprev(e);
  }
  EdgeId reversed(EdgeId e) {
    ++counts_.sym;
    return sym(e);
  }
  CountedWalk ended_at(EdgeId e) const { return {e, counts_}; }

 private:
  const Triangulation& t_;
  const Point& p_;
  WalkCounts counts_;
};

}  // namespace

// Each edge that the walk goes on to is asked for twice, as printed in 1985.
CountedWalk walk_of_guibas_stolfi(const Triangulation& t, const Point& p, EdgeId start) {
  Counter walk(t, p);
  EdgeId e = start;
  while (true) {
    if (walk.is_org(e) || walk.is_dest(e)) return walk.ended_at(e);
    if (walk.is_right_of(e)) {
      e = walk.reversed(e);
    } else if (!walk.is_right_of(walk.onext(e))) {
      e = walk.onext(e);
    } else if (!walk.is_right_of(walk.dprev(e))) {
      e = walk.dprev(e);
    } else {
      return walk.ended_at(e);
    }
  }
}

// States s1 and s2 of Fig. 2.8: after a step over Onext the origin is the old one and Dprev is tested first, after one
// over Dprev the other way round. The second test of a state is that of s4 or s3.
CountedWalk walk_of_bossen(const Triangulation& t, const Point& p, EdgeId start) {
  Counter walk(t, p);
  EdgeId e = walk.is_right_of(start) ? walk.reversed(start) : start;
  if (walk.is_org(e) || walk.is_dest(e)) return walk.ended_at(e);
  bool onext_first = true;
  while (true) {
    EdgeId f = onext_first ? walk.onext(e) : walk.dprev(e);
    bool over_onext = onext_first;
    if (walk.is_right_of(f)) {
      f = onext_first ? walk.dprev(e) : walk.onext(e);
      over_onext = !onext_first;
      if (walk.is_right_of(f)) return walk.ended_at(e);
    }
    e = f;
    if (over_onext ? walk.is_dest(e) : walk.is_org(e)) return walk.ended_at(e);
    onext_first = !over_onext;
  }
}

}  // namespace parmesan::thesis
