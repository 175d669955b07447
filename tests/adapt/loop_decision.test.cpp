#include "adapt/loop_decision.h"

#include <catch2/catch.hpp>

#include "tests/adapt/loop_cases.h"

using namespace parmesan;

namespace {

SizeGoal goal_of(std::optional<double> l2_error, std::optional<std::int64_t> vertices,
                 std::optional<std::int64_t> max_vertices) {
  Targets targets;
  targets.l2_error = l2_error;
  targets.vertices = vertices;
  targets.max_vertices = max_vertices;
  return size_goal(targets);
}

}  // namespace

TEST_CASE("a number of vertices is aimed at, unless it or a smaller budget is what errors may take", "[adapt][loop]") {
  SECTION("alone") {
    const SizeGoal goal = goal_of({}, 500, {});
    CHECK(goal.vertices == 500.0);
    CHECK_FALSE(goal.cap);
  }
  SECTION("with an error target it is a budget") {
    const SizeGoal goal = goal_of(1e-3, 500, {});
    CHECK_FALSE(goal.vertices);
    CHECK(goal.cap == 500.0);
  }
  SECTION("a budget above it does not matter, one below takes its place") {
    CHECK(goal_of({}, 500, 1000).vertices == 500.0);
    const SizeGoal goal = goal_of({}, 500, 400);
    CHECK_FALSE(goal.vertices);
    CHECK(*goal.cap < 400.0);
    CHECK(*goal.cap > 0.95 * 400.0);
  }
}

TEST_CASE("an estimate that met the targets is refuted by a mesh, no smaller, that misses them", "[adapt][loop]") {
  Case input = support::poisson_case("x^2", R"({"l2_error": 1e-3})");
  LoopState state;
  state.met.emplace();
  state.met->mesh.points.resize(100);
  state.summary.iterations.emplace_back();
  const auto refuted_after = [&](double vertices, double error) {
    state.history = {{100, 100, 0.9}, {vertices, vertices, error}};
    return is_refuted(input, state);
  };
  CHECK(refuted_after(110, 1.2));
  CHECK_FALSE(refuted_after(90, 1.2));
  CHECK_FALSE(refuted_after(110, 0.8));
  state.summary.iterations.back().solution_error.emplace();  // what is known is no estimate
  CHECK_FALSE(refuted_after(110, 1.2));
}
