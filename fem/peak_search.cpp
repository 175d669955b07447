#include "fem/peak_search.h"

#include <algorithm>

namespace parmesan {
namespace {

class PeakSearch {
 public:
  explicit PeakSearch(const std::function<double(const Barycentric&)>& size) : size_(size) {}

  double run() {
    constexpr int order = 8, halvings = 6;
    for (int i = 0; i <= order; ++i)
      for (int j = 0; i + j <= order; ++j)
        look_at({static_cast<double>(i) / order, static_cast<double>(j) / order,
                 static_cast<double>(order - i - j) / order});
    double step = 0.5 / order;
    for (int h = 0; h < halvings; ++h, step *= 0.5) look_around(step);
    return largest_;
  }

 private:
  void look_at(const Barycentric& lambda) {
    constexpr double inside = 1e-9;
    if (*std::ranges::min_element(lambda) < 0.0) return;
    Barycentric inner = lambda;
    for (double& l : inner) l += inside * (1.0 / 3.0 - l);
    const double size = size_(inner);
    if (size <= largest_) return;
    largest_ = size;
    best_ = lambda;
  }

  void look_around(double step) {
    const Barycentric center = best_;
    for (std::size_t from = 0; from < 3; ++from) {
      for (std::size_t to = 0; to < 3; ++to) {
        Barycentric lambda = center;
        lambda[from] -= step;
        lambda[to] += step;
        if (from != to) look_at(lambda);
      }
    }
  }

  const std::function<double(const Barycentric&)>& size_;
  Barycentric best_{};
  double largest_ = 0.0;
};

}  // namespace

double peak_in_triangle(const std::function<double(const Barycentric&)>& size) { return PeakSearch(size).run(); }

}  // namespace parmesan
