#include "adapt/summary.h"

#include <catch2/catch.hpp>
#include <cstdlib>  // defines __GLIBC__ where it is that
#include <limits>
#ifdef __GLIBC__
#include <gnu/libc-version.h>
#endif

#include "tests/support/meshes.h"

using namespace parmesan;

namespace {

Summary one_row() {
  Summary summary;
  summary.case_name = std::string("a case");
  summary.stop_reason = StopReason::VertexBudget;
  IterationRow row;
  row.vertices = 12;
  row.interpolation_error = ErrorNorms{1.0, 0.5, 2.0, 3.0};
  row.seconds.mesh = 0.25;
  summary.iterations.push_back(row);
  return summary;
}

}  // namespace

TEST_CASE("summary.json has every field that users rely on", "[adapt][summary]") {
  const nlohmann::ordered_json json = to_json(one_row());
  for (const char* key :
       {"case", "version", "math_library", "seed", "threads", "stop_reason", "targets_met", "iterations"})
    CHECK(json.contains(key));
  CHECK(json["stop_reason"] == "vertex_budget");
#ifdef __GLIBC__
  CHECK(json["math_library"] == std::string("glibc ") + gnu_get_libc_version());
#endif
  const nlohmann::ordered_json& row = json["iterations"][0];
  for (const char* key : {"iteration",  "vertices",       "triangles",       "complexity",  "interpolation_error",
                          "efficiency", "solution_error", "estimated_error", "effectivity", "clipped",
                          "goal",       "unit_edges",     "edge_length",     "quality",     "worst_element",
                          "misfits",    "start",          "start_reason",    "seconds",     "peak_memory_mb"})
    CHECK(row.contains(key));
  CHECK(row["interpolation_error"]["linf"] == 2.0);
  CHECK(row["seconds"]["total"] == 0.25);
}

TEST_CASE("summary.json says where a mesh misses its metric and why, and what it was started from",
          "[adapt][summary]") {
  Summary summary = one_row();
  IterationRow& row = summary.iterations[0];
  row.diagnosis.short_edges = {{MisfitReason::ClosePoints, 3, {0.25, 0.5}, 0.125}};
  row.diagnosis.poor_triangles = {{MisfitReason::SharpCorner, 2, {1.0, 0.0}, 0.2}};
  row.start = Start::RefinedPreviousMesh;
  row.start_reason = "it fits";
  const nlohmann::ordered_json json = to_json(summary)["iterations"][0];
  CHECK(json["misfits"]["long_edges"].empty());
  CHECK(json["misfits"]["short_edges"].dump() ==
        R"([{"reason":"close_points","count":3,"worst":{"x":0.25,"y":0.5,"length":0.125}}])");
  CHECK(json["misfits"]["poor_triangles"].dump() ==
        R"([{"reason":"sharp_corner","count":2,"worst":{"x":1.0,"y":0.0,"quality":0.2}}])");
  CHECK(json["start"] == "refined_previous_mesh");
  CHECK(json["start_reason"] == "it fits");
}

TEST_CASE("summary.json has the functional that the estimate corrects, and what the residuals say",
          "[adapt][summary]") {
  Summary summary = one_row();
  IterationRow& row = summary.iterations[0];
  row.goal = GoalRow{2.0, {0.25, 0.5}, 0.2};
  row.solution_error = ErrorNorms{1.0, 0.5, 2.0, 4.0};
  row.estimated_error = EstimatedError{0.25, 2.0, 1.0};
  row.residual_h1 = 3.0;
  const nlohmann::ordered_json json = to_json(summary)["iterations"][0];
  CHECK(json["goal"]["corrected"] == 2.25);
  CHECK(json["goal"]["corrected_error"].get<double>() == Approx(-0.05).epsilon(1e-12));
  CHECK(json["goal"]["effectivity"].get<double>() == Approx(1.25).epsilon(1e-12));
  CHECK(json["estimated_error"]["h1_residual"] == 3.0);
  CHECK(json["effectivity"]["h1"] == 0.5);
  CHECK(json["effectivity"]["h1_residual"] == 0.75);
  row.goal->error.reset();
  CHECK(to_json(summary)["iterations"][0]["goal"]["corrected_error"].is_null());
}

TEST_CASE("absent and not finite values are null", "[adapt][summary]") {
  Summary summary = one_row();
  summary.iterations[0].interpolation_error->h1 = std::numeric_limits<double>::infinity();
  const nlohmann::ordered_json row = to_json(summary)["iterations"][0];
  CHECK(row["solution_error"].is_null());
  CHECK(row["efficiency"].is_null());
  CHECK(row["goal"].is_null());
  CHECK(row["interpolation_error"]["h1"].is_null());
}

TEST_CASE("set_quality says where the worst element lies", "[adapt][summary]") {
  Mesh mesh = support::rectangle_mesh(1, 1);
  MeshQuality quality;
  quality.worst_triangle = 1;  // (0,0) (1,1) (0,1)
  quality.quality_min = 0.3;
  IterationRow row;
  set_quality(row, mesh, quality);
  CHECK(row.worst.center.x == Approx(1.0 / 3.0).epsilon(1e-12));
  CHECK(row.worst.center.y == Approx(2.0 / 3.0).epsilon(1e-12));
  CHECK(row.worst.quality == 0.3);
}
