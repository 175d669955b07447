#include "mesher/particles/alive_particles.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <set>

using namespace parmesan;

TEST_CASE("only particles that are alive are picked, all of them as often", "[mesher][particles][thesis]") {
  AliveParticles alive(Picking::Uniform);
  for (const VertexId v : {3, 5, 8, 13}) alive.wake(v, 1.0);
  alive.wake(5, 1.0);
  alive.put_to_sleep(8);
  alive.put_to_sleep(100);
  CHECK(alive.size() == 3);
  CHECK(alive.contains(13));
  CHECK_FALSE(alive.contains(8));
  std::mt19937_64 engine(1);
  std::map<VertexId, int> picks;
  constexpr int n = 30000;
  for (int i = 0; i < n; ++i) ++picks[alive.pick(engine)];
  REQUIRE(picks.size() == 3);
  // four standard deviations of a binomial count
  for (const auto& [v, count] : picks) CHECK(std::abs(count - n / 3) < 4.0 * std::sqrt(n * 2.0 / 9.0));
}

TEST_CASE("picks by speed are as frequent as the weights, also when those change", "[mesher][particles][thesis]") {
  AliveParticles alive(Picking::BySpeed);
  for (VertexId v = 0; v < 40; ++v) alive.wake(v, 5.0);
  for (VertexId v = 0; v < 40; ++v)
    if (v != 7 && v != 31) alive.put_to_sleep(v);
  alive.wake(31, 15.0);
  std::mt19937_64 engine(1);
  constexpr int n = 20000;
  int of_31 = 0;
  for (int i = 0; i < n; ++i) {
    const VertexId v = alive.pick(engine);
    REQUIRE((v == 7 || v == 31));
    of_31 += v == 31 ? 1 : 0;
  }
  CHECK(std::abs(of_31 - 0.75 * n) < 4.0 * std::sqrt(n * 0.75 * 0.25));
}

TEST_CASE("random wakes and sleeps agree with a set", "[mesher][particles][thesis]") {
  AliveParticles alive(GENERATE(Picking::Uniform, Picking::BySpeed));
  std::set<VertexId> expected;
  std::mt19937_64 engine(3);
  for (int i = 0; i < 5000; ++i) {
    const auto v = static_cast<VertexId>(engine() % 200);
    if (engine() % 2 == 0) {
      alive.wake(v, 0.01 + static_cast<double>(engine() % 5));
      expected.insert(v);
    } else {
      alive.put_to_sleep(v);
      expected.erase(v);
    }
    if (!expected.empty()) REQUIRE(expected.contains(alive.pick(engine)));
  }
  CHECK(alive.size() == static_cast<std::int64_t>(expected.size()));
}
