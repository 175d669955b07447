#include "mesher/geometry/curve_contacts.h"

#include <algorithm>
#include <cmath>

#include "mesher/geometry/segment_path.h"
#include "mesher/index.h"

namespace parmesan {
namespace {

/// Where a function changes its sign between two arguments, by false position, with the value at an end that stays
/// halved each time.
template <class Function>
double sign_change(Function f, double low, double high) {
  constexpr int max_steps = 100;
  constexpr double least_step = 1e-16;
  double at_low = f(low);
  double at_high = f(high);
  for (int i = 0; i < max_steps && high - low > least_step && at_low != 0.0 && at_high != 0.0; ++i) {
    const double middle = std::clamp(low + (high - low) * at_low / (at_low - at_high), low, high);
    const double value = f(middle);
    if (middle == low || middle == high) break;
    if ((value > 0.0) == (at_low > 0.0)) {
      low = middle;
      at_low = value;
      at_high *= 0.5;
    } else {
      high = middle;
      at_high = value;
      at_low *= 0.5;
    }
  }
  return std::abs(at_low) < std::abs(at_high) ? low : high;
}

}  // namespace

CurveContacts::CurveContacts(const Domain& domain, int curved, int other)
    : domain_(domain), curved_(domain.segments[at(curved)]), other_(domain.segments[at(other)]) {}

double CurveContacts::reach_near(const Point& p) const {
  double least = reach(domain_.curves[at(curved_.curve)], p);
  if (!other_.is_straight()) least = std::min(least, reach(domain_.curves[at(other_.curve)], p));
  return least;
}

CurveContacts::View CurveContacts::view(double u) const {
  const Point p = point_on(domain_, curved_, u);
  const double v = std::clamp(parameter_on(domain_, other_, p), 0.0, 1.0);
  const Point foot = point_on(domain_, other_, v);
  Vector along = derivative_on(domain_, other_, v);
  if (!other_.is_straight()) along = domain_.curves[at(other_.curve)].tangent(v);
  along = (1.0 / norm(along)) * along;
  const Vector tangent = domain_.curves[at(curved_.curve)].tangent(u);
  return {cross(along, p - foot), cross(along, tangent), norm(p - foot), other_.is_straight() ? foot : p};
}

void CurveContacts::look_for_crossing(double from, double to) {
  const auto height = [this](double u) { return view(u).height; };
  if ((height(from) > 0.0) == (height(to) > 0.0)) return;
  const View best = view(sign_change(height, from, to));
  if (best.distance <= reach_near(best.place)) crossings_.push_back(best.place);
}

void CurveContacts::look_between(double from, double to) {
  constexpr int parts = 6;
  const auto slope = [this](double u) { return view(u).slope; };
  for (int i = 0; i < parts; ++i) {
    const double low = from + (to - from) * i / parts;
    const double high = from + (to - from) * (i + 1) / parts;
    if ((slope(low) > 0.0) == (slope(high) > 0.0)) {
      look_for_crossing(low, high);
      continue;
    }
    const double top = sign_change(slope, low, high);
    const View best = view(top);
    if (best.distance <= reach_near(best.place)) touches_.push_back(best.place);
    look_for_crossing(low, top);
    look_for_crossing(top, high);
  }
}

bool CurveContacts::is_of_one_stretch(const Point& p, const Point& q) const {
  const double near = reach_near(p);
  if (norm(p - q) <= near) return true;
  const double from = parameter_on(domain_, curved_, p);
  const double to = parameter_on(domain_, curved_, q);
  const auto is_near = [&](double share) { return view(from + share * (to - from)).distance <= near; };
  return is_near(0.5) && is_near(0.25) && is_near(0.75) && is_near(0.125) && is_near(0.875);
}

std::vector<Point> CurveContacts::places() const {
  std::vector<Point> known;
  for (const int end : {curved_.a, curved_.b})
    if (end == other_.a || end == other_.b) known.push_back(domain_.points[at(end)]);
  const auto first_new = static_cast<std::ptrdiff_t>(known.size());
  for (const std::vector<Point>* found : {&touches_, &crossings_}) {
    for (const Point& p : *found)
      if (std::ranges::none_of(known, [&](const Point& q) { return is_of_one_stretch(p, q); })) known.push_back(p);
  }
  return {known.begin() + first_new, known.end()};
}

}  // namespace parmesan
