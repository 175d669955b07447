#include "adapt/sizing.h"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

using namespace parmesan;

namespace {

const SizeGoal to_error{true, std::nullopt, std::nullopt};
const SizeGoal to_size{false, 16000.0, std::nullopt};

/// How the loop ends when every further pass has this error.
std::optional<StopReason> go_on(std::vector<SizeStep>& history, const SizeGoal& goal, double error) {
  std::optional<StopReason> stop;
  for (int pass = 0; pass < 30 && !stop; ++pass) {
    const SizeDecision d = next_size(history, goal);
    stop = d.stop;
    history.push_back({d.asked, d.asked, error});
  }
  return stop;
}

}  // namespace

TEST_CASE("predicted_vertices inverts error = c N^-order", "[adapt][sizing]") {
  CHECK(predicted_vertices(1000, 8e-3, 1e-3, 1.0) == Approx(8000.0).epsilon(1e-12));
  CHECK(predicted_vertices(1000, 8e-3, 1e-3, 0.5) == Approx(64000.0).epsilon(1e-12));
  CHECK(predicted_vertices(1000, 1e-3, 1e-3, 1.0) == Approx(1000.0).epsilon(1e-12));
}

TEST_CASE("observed_order is that between the last passes of two sizes, in bounds", "[adapt][sizing]") {
  CHECK(observed_order(std::vector<SizeStep>{{400, 400, 1.0}}) == 1.0);
  CHECK(observed_order(std::vector<SizeStep>{{400, 400, 9.0}, {400, 400, 1.0}, {1600, 1600, 0.5}}) ==
        Approx(0.75).epsilon(1e-12));
  CHECK(observed_order(std::vector<SizeStep>{{400, 400, 1.0}, {1600, 1600, 0.01}}) == 1.1);
  CHECK(observed_order(std::vector<SizeStep>{{400, 400, 1.0}, {1600, 1600, 4.0}}) == 0.4);
}

TEST_CASE("next_size stops as soon as the error targets are met", "[adapt][sizing]") {
  const SizeDecision d = next_size(std::vector<SizeStep>{{400, 410, 0.99, false}}, to_error);
  CHECK(d.stop == StopReason::ErrorTarget);
}

TEST_CASE("next_size makes a mesh smaller that meets the targets with vertices to spare", "[adapt][sizing]") {
  SizeGoal goal = to_error;
  goal.max_passes = 12;
  std::vector<SizeStep> history{{400, 400, 20}, {400, 400, 18}, {400, 400, 17}, {1600, 1600, 4.3}, {5200, 5200, 0.8}};
  // error ~ N^-1.1 at most: 5200 0.8^(1/1.1) = 4245, and 2 % more.
  const SizeDecision smaller = next_size(history, goal);
  CHECK_FALSE(smaller.stop.has_value());
  CHECK(smaller.asked == Approx(4330).epsilon(0.01));
  SECTION("not for a few per cent") {
    history.back().error = 0.95;
    CHECK(next_size(history, goal).stop == StopReason::ErrorTarget);
  }
  SECTION("to 3/4 of the prediction where the last step only began to resolve") {
    history.back().error = 0.7;  // it fell 6.1 times on 3.25 times as many vertices: order 1.54
    CHECK(next_size(history, goal).asked == Approx(0.75 * 5200 * std::pow(0.7, 1 / 1.1)).epsilon(1e-9));
  }
  SECTION("not where passes to come back are lacking") {
    goal.max_passes = 7;
    CHECK(next_size(history, goal).stop == StopReason::ErrorTarget);
  }
  SECTION("twice at most, never to less than half, nor below the first size") {
    history.back().error = 0.01;
    CHECK(next_size(history, goal).asked == 2600);
    history.push_back({2600, 2600, 0.02});
    CHECK(next_size(history, goal).asked == 1300);
    history.push_back({1300, 1300, 0.04});
    CHECK(next_size(history, goal).stop == StopReason::ErrorTarget);
    const std::vector<SizeStep> small{{400, 400, 20}, {400, 400, 2}, {420, 420, 0.2}};
    CHECK(next_size(small, goal).stop == StopReason::ErrorTarget);
  }
}

TEST_CASE("next_size stays at the first size while passes still pay", "[adapt][sizing]") {
  std::vector<SizeStep> history{{400, 400, 100, false}, {400, 400, 30, true}};
  CHECK(next_size(history, to_error).asked == 400);
  history.push_back({400, 400, 12, true});
  CHECK(next_size(history, to_error).asked == 400);
  history.push_back({400, 400, 11, true});  // a factor of 1.1 only: time to grow, but by 4 at most
  CHECK(next_size(history, to_error).asked == 1600);
}

TEST_CASE("next_size repeats a size at which the error falls much faster than the size grew", "[adapt][sizing]") {
  std::vector<SizeStep> history{{400, 400, 300}, {400, 400, 300}, {400, 400, 300}, {1600, 1600, 30}};
  CHECK(next_size(history, to_error).asked == 1600);  // 75 was to be expected: the layer is being found
  history.push_back({1600, 1600, 25});
  CHECK(next_size(history, to_error).asked > 1600);
}

TEST_CASE("next_size at most doubles a size whose error fell faster than meshes that resolve can", "[adapt][sizing]") {
  const std::vector<SizeStep> coarse{{400, 400, 900}, {400, 400, 900}, {400, 400, 900}};
  std::vector<SizeStep> history = coarse;
  history.insert(history.end(), {{1600, 1600, 40}, {1600, 1600, 36}});  // 225 was to be expected
  CHECK(next_size(history, to_error).asked == 3200);
  history = coarse;
  history.insert(history.end(), {{1600, 1600, 225}, {1600, 1600, 225}});
  CHECK(next_size(history, to_error).asked == 6400);
}

TEST_CASE("next_size at most doubles after a size that was left while passes still gained", "[adapt][sizing]") {
  std::vector<SizeStep> history{{400, 400, 900}, {400, 400, 780}, {400, 400, 600}, {1600, 1600, 150}};
  CHECK(next_size(history, to_error).asked == 3200);
  history[2].error = 700;
  CHECK(next_size(history, to_error).asked == 6400);
}

TEST_CASE("next_size repeats a size at which the mesh has not yet found the layer", "[adapt][sizing]") {
  const std::vector<SizeStep> settled{{400, 400, 30, true}, {400, 400, 20, true}, {400, 400, 19, true}};
  std::vector<SizeStep> history = settled;
  history.push_back({1600, 1600, 12});  // 19 / 4 was to be expected
  CHECK(next_size(history, to_error).asked == 1600);
  history.back().error = 5.0;
  CHECK(next_size(history, to_error).asked > 1600);
}

TEST_CASE("next_size lands on an error target with a few per cent to spare", "[adapt][sizing]") {
  // error = 8000 / N exactly, so 8000 vertices are wanted.
  std::vector<SizeStep> history{{1000, 1000, 8}, {1000, 1000, 8}, {1000, 1000, 8}, {4000, 4000, 2}};
  SizeDecision d = next_size(history, to_error);
  CHECK_FALSE(d.stop.has_value());
  CHECK(d.asked == Approx(6000.0).epsilon(1e-12));  // from below first
  history.push_back({6000, 6000, 8.0 / 6.0});
  d = next_size(history, to_error);
  CHECK(d.asked > 8000.0);
  CHECK(d.asked < 8000.0 * 1.05);
}

TEST_CASE("next_size corrects a near miss without further settling", "[adapt][sizing]") {
  const std::vector<SizeStep> history{{1000, 1000, 8}, {1000, 1000, 8}, {1000, 1000, 8}, {4000, 4000, 1.05}};
  const SizeDecision d = next_size(history, to_error);
  CHECK(d.asked > 4000.0);
  CHECK(d.asked < 4000.0 * 1.15);
}

TEST_CASE("next_size does not judge a first pass that has nothing before it", "[adapt][sizing]") {
  const SizeDecision d = next_size(std::vector<SizeStep>{{400, 400, 3, true}}, to_size);
  CHECK(d.asked == 400);
  CHECK_FALSE(d.stop.has_value());
}

TEST_CASE("next_size climbs to the size aimed at and settles there", "[adapt][sizing]") {
  std::vector<SizeStep> history{{400, 400, 9, false}, {400, 400, 1}, {400, 400, 1}, {400, 400, 1}};
  CHECK(next_size(history, to_size).asked == 1600);
  history.push_back({1600, 1600, 0.25});
  CHECK(next_size(history, to_size).asked == 6400);
  history.push_back({6400, 6400, 0.0625});
  CHECK(next_size(history, to_size).asked == 16000);
  for (const double error : {0.03, 0.026, 0.0258}) {
    CHECK_FALSE(next_size(history, to_size).stop.has_value());
    history.push_back({16000, 16000, error});
  }
  CHECK(next_size(history, to_size).stop == StopReason::Vertices);
}

TEST_CASE("next_size comes to the size aimed at within the passes there are, and has some to settle",
          "[adapt][sizing]") {
  SizeGoal goal = to_size;
  goal.max_passes = GENERATE(2, 3, 4, 6, 8, 12);
  const double gain = GENERATE(1.0, 1.7);  // the second never settles by itself
  std::vector<SizeStep> history{{400, 400, 1.0, false}};
  while (static_cast<int>(history.size()) < goal.max_passes) {
    const SizeDecision d = next_size(history, goal);
    if (d.stop) break;
    history.push_back({d.asked, d.asked, history.back().error * history.back().vertices / (gain * d.asked)});
  }
  const auto at_aim = std::ranges::count_if(history, [](const SizeStep& s) { return has_size(s.vertices, 16000.0); });
  CHECK(at_aim >= std::min(goal.max_passes - 1, 3));
}

TEST_CASE("next_size does not end on a mesh that is off the size aimed at by more than 3 %", "[adapt][sizing]") {
  const double vertices = GENERATE(15500.0, 15540.0, 16470.0, 16500.0);
  const std::vector<SizeStep> history(4, {16000, vertices, 1.0});
  CHECK(next_size(history, to_size).stop.has_value() == (std::abs(vertices / 16000.0 - 1.0) <= 0.03));
  CHECK(next_size(std::vector<SizeStep>(8, {16000, 15000, 1.0}), to_size).stop == StopReason::Stagnated);  // in vain
}

TEST_CASE("next_size never asks for more than the cap and ends there", "[adapt][sizing]") {
  const SizeGoal goal{true, std::nullopt, 5000.0};
  std::vector<SizeStep> history{{2000, 2000, 50}, {2000, 2000, 50}, {2000, 2000, 50}};
  CHECK(next_size(history, goal).asked == 5000);
  for (int pass = 0; pass < 3; ++pass) history.push_back({5000, 5000, 20});
  CHECK(next_size(history, goal).stop == StopReason::VertexBudget);
}

TEST_CASE("next_size gives up when more vertices do not help", "[adapt][sizing]") {
  std::vector<SizeStep> history{{400, 400, 10, false}, {400, 400, 5}, {400, 400, 5}, {400, 400, 5}};
  CHECK(go_on(history, to_error, 5) == StopReason::Stagnated);
}

TEST_CASE("next_size goes on to a size aimed at whatever the error does", "[adapt][sizing]") {
  // Errors that are but estimated grow where the meshes begin to see a layer.
  const bool is_cap = GENERATE(false, true);
  const SizeGoal goal = is_cap ? SizeGoal{false, std::nullopt, 16000.0} : to_size;
  std::vector<SizeStep> history{{400, 400, 10, false}, {400, 400, 1}, {400, 400, 1}, {400, 400, 1}};
  CHECK(go_on(history, goal, 5) == (is_cap ? StopReason::VertexBudget : StopReason::Vertices));
  CHECK(history.back().asked == 16000);
}

TEST_CASE("next_size ends at the first size when nothing is aimed at", "[adapt][sizing]") {
  const std::vector<SizeStep> history{{400, 400, 2, false}, {400, 400, 1}, {400, 400, 1}, {400, 400, 0.99}};
  CHECK(next_size(history, SizeGoal{}).stop == StopReason::Unchanged);
}
