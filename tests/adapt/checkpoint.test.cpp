#include "adapt/checkpoint.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>

#include "adapt/adapt_loop.h"
#include "mesher/errors.h"
#include "tests/adapt/loop_cases.h"
#include "tests/support/temporary_folder.h"

using namespace parmesan;
using support::goal_case;
using support::interpolation_case;
using support::poisson_case;
using support::TemporaryFolder;

namespace {

constexpr std::uint64_t some_case = 42;

std::vector<LoopState> states_of(const Case& input, LoopResult& result) {
  std::vector<LoopState> states;
  LoopOptions options;
  options.observer = [&states](const LoopState& state) { states.push_back(state); };
  result = adapt(input, options);
  return states;
}

LoopState some_state() {
  LoopResult ignored;
  return states_of(interpolation_case("sin(6*x)*y^2", R"({"vertices": 200, "max_iterations": 2})"), ignored).back();
}

}  // namespace

TEST_CASE("a loop resumed after any row, through a checkpoint, ends bit by bit as it would have",
          "[adapt][resume][slow]") {
  Case input = GENERATE(poisson_case("tanh(20*(x - y^2))", R"({"l2_error": 2e-3, "max_vertices": 3000})"),
                        interpolation_case("sin(6*x)*y^2", R"({"vertices": 900})"),
                        interpolation_case("tanh(20*(x - y^2))", R"({"vertices": 500})"),
                        goal_case(R"({"value": [0.3, 0.4]})", R"({"goal_error": 1e-3, "max_vertices": 600})"));
  input.lower_error = input.exact->text().starts_with("sin");  // then the mesh before is a part of the state
  LoopResult whole;
  for (const LoopState& state : states_of(input, whole)) {
    const Checkpoint read = decode_checkpoint(encode_checkpoint(state, some_case));
    const LoopResult resumed = adapt(input, {}, {.resume = &read.state});
    INFO("resumed after row " << state.history.size());
    CHECK(resumed.last.mesh.points == whole.last.mesh.points);
    CHECK(resumed.last.mesh.triangles == whole.last.mesh.triangles);
    CHECK(resumed.last.mesh.labels == whole.last.mesh.labels);
    CHECK(resumed.last.values == whole.last.values);
    CHECK(resumed.summary.stop_reason == whole.summary.stop_reason);
    CHECK(resumed.summary.warnings == whole.summary.warnings);
    REQUIRE(resumed.summary.iterations.size() == whole.summary.iterations.size());
    for (std::size_t k = 0; k < whole.summary.iterations.size(); ++k) {
      auto a = to_json(resumed.summary.iterations[k]), b = to_json(whole.summary.iterations[k]);
      for (const char* machine : {"seconds", "peak_memory_mb"}) a.erase(machine), b.erase(machine);
      CHECK(a == b);
    }
  }
}

TEST_CASE("a checkpoint with any one bit flipped, or cut anywhere, is refused", "[adapt][resume][errors]") {
  const std::string bytes = encode_checkpoint(some_state(), some_case);
  REQUIRE(decode_checkpoint(bytes).case_hash == some_case);
  std::mt19937 engine(1);
  for (int k = 0; k < 300; ++k) {
    const std::size_t place = std::uniform_int_distribution<std::size_t>(0, bytes.size() - 1)(engine);
    std::string flipped = bytes;
    flipped[place] = static_cast<char>(flipped[place] ^ (1 << (k % 8)));
    CHECK_THROWS_AS(decode_checkpoint(flipped), InputError);
    CHECK_THROWS_AS(decode_checkpoint(bytes.substr(0, place)), InputError);
  }
  CHECK_THROWS_AS(decode_checkpoint(bytes + "x"), InputError);
  CHECK_THROWS_AS(decode_checkpoint(""), InputError);
}

TEST_CASE("counts in a checkpoint are not believed, even when its checksum is right", "[adapt][resume][errors]") {
  const std::string bytes = encode_checkpoint(some_state(), some_case);
  std::mt19937 engine(2);
  int refused = 0;
  for (int k = 0; k < 300; ++k) {
    std::string forged = bytes.substr(0, bytes.size() - 8);
    const std::size_t place =
        std::uniform_int_distribution<std::size_t>(0, std::min<std::size_t>(forged.size(), 4000) - 8)(engine);
    for (std::size_t i = 0; i < 8; ++i) forged[place + i] = static_cast<char>(i < 7 ? 0xff : 0x7f);
    const std::uint64_t sum = checksum(forged);
    forged.append(reinterpret_cast<const char*>(&sum), sizeof sum);
    try {
      decode_checkpoint(forged);  // a coordinate may be anything
    } catch (const InputError&) {
      ++refused;
    }
  }
  CHECK(refused > 10);
}

TEST_CASE("a state that nothing could go on from is refused, even when its checksum is right",
          "[adapt][resume][errors]") {
  const LoopState sound = some_state();
  const auto refused = [&sound](const auto& spoil) {
    LoopState state = sound;
    spoil(state);
    try {
      decode_checkpoint(encode_checkpoint(state, some_case));
    } catch (const InputError&) {
      return true;
    }
    return false;
  };
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(refused([](LoopState&) {}));
  CHECK(refused([](LoopState& s) { s.last.values.front() = nan; }));
  CHECK(refused([](LoopState& s) { s.last.values.pop_back(); }));
  CHECK(refused([](LoopState& s) { s.last.metrics.pop_back(); }));
  CHECK(refused([](LoopState& s) { s.last.dual = {1.0}; }));
  CHECK(refused([](LoopState& s) { s.last.mesh.points.front().x = HUGE_VAL; }));
  CHECK(refused([](LoopState& s) { std::swap(s.last.mesh.triangles[0][0], s.last.mesh.triangles[0][1]); }));
  CHECK(refused([](LoopState& s) { s.last.mesh.triangles[0][0] = -1; }));
  CHECK(refused([](LoopState& s) { s.last.mesh.required.vertices = {1 << 30}; }));
  CHECK(refused([](LoopState& s) { s.last.relaxed = Mesh(); }));
  CHECK(refused([](LoopState& s) { s.asked = nan; }));
  CHECK(refused([](LoopState& s) { s.history.front().asked = -1.0; }));
  CHECK(refused([](LoopState& s) { s.history.clear(); }));
  CHECK(refused([](LoopState& s) { s.summary.iterations.back().iteration = -1; }));
  CHECK(refused([](LoopState& s) { s.summary.iterations.back().start = static_cast<Start>(99); }));
  CHECK(refused([](LoopState& s) { s.summary.stop_reason = static_cast<StopReason>(-5); }));
  CHECK(refused([](LoopState& s) {
    s.last.report.diagnosis.poor_triangles.emplace_back().reason = static_cast<MisfitReason>(99);
  }));
}

TEST_CASE("a checkpoint of another version of the program is refused as such", "[adapt][resume][errors]") {
  std::string bytes = encode_checkpoint(some_state(), some_case);
  bytes.resize(bytes.size() - sizeof(std::uint64_t));
  const std::size_t place = bytes.find(PARMESAN_VERSION);
  REQUIRE(place < 32);
  bytes[place] = '9';
  const std::uint64_t sum = checksum(bytes);
  bytes.append(reinterpret_cast<const char*>(&sum), sizeof sum);
  CHECK_THROWS_WITH(decode_checkpoint(bytes), Catch::Contains("another version"));
}

TEST_CASE("two generations of checkpoints are kept, and the older one serves where the newer is damaged",
          "[adapt][resume]") {
  const TemporaryFolder folder;
  LoopResult result;
  const auto states =
      states_of(interpolation_case("sin(6*x)*y^2", R"({"vertices": 200, "max_iterations": 4})"), result);
  REQUIRE(states.size() == 4);
  CHECK_FALSE(find_checkpoint(folder.path()).checkpoint);
  for (const LoopState& state : states) {
    write_checkpoint(folder.path(), state, some_case);
    CHECK(find_checkpoint(folder.path()).checkpoint->state.history.size() == state.history.size());
  }
  const std::string newest = folder / "checkpoint/odd.state";  // rows count from 0
  std::ofstream(folder / "checkpoint/even.state", std::ios::app) << "damaged";
  CHECK(find_checkpoint(folder.path()).problems.empty());  // of what is not needed nothing is read but its head
  write_checkpoint(folder.path(), states[2], some_case);
  SECTION("cut short") { std::filesystem::resize_file(newest, 1000); }
  SECTION("another file") { std::ofstream(newest) << "not a checkpoint"; }
  SECTION("a link to elsewhere") {
    std::filesystem::remove(newest);
    std::filesystem::create_symlink("/dev/zero", newest);
  }
  const FoundCheckpoint found = find_checkpoint(folder.path());
  REQUIRE(found.checkpoint);
  CHECK(found.checkpoint->state.history.size() == 3);
  REQUIRE(found.problems.size() == 1);
  CHECK_THAT(found.problems[0], Catch::Contains("odd.state"));
}
