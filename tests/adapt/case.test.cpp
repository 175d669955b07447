#include "adapt/case.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>

#include "adapt/case_schema.h"
#include "case_support.h"

namespace parmesan {
namespace {

using support::case_text;
using support::issue_text;
using support::kZeroBoundary;

std::vector<std::string> case_files() {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(std::string(PARMESAN_SOURCE_DIR) + "/cases")) {
    if (entry.path().extension() == ".json") files.push_back(entry.path().string());
  }
  return files;
}

}  // namespace

TEST_CASE("parse_case fills in every default", "[adapt][case]") {
  const Case c = parse_case(case_text(kZeroBoundary), "some/folder/heat.json");
  CHECK(c.name == "heat");
  CHECK(c.title.empty());
  CHECK_FALSE(c.interpolation);
  CHECK_FALSE(c.exact);
  CHECK(c.metric.kind == MetricKind::SignAware);
  CHECK(c.metric.norm == 2.0);
  CHECK(c.targets.max_iterations == 20);
  CHECK_FALSE(c.targets.l2_error);
  CHECK(c.mesher.preset == Preset::Good);
  CHECK(c.mesher.seed == 1);
  CHECK_FALSE(c.lower_error);
  CHECK(c.initial_vertices == 400);
  CHECK(c.output.formats == std::vector<std::string>{"vtu", "mesh", "svg"});
  CHECK(c.resolved["problem"]["diffusion"] == 1);
  CHECK(c.resolved["problem"]["source"] == 0);
  CHECK(c.resolved["name"] == "heat");
  CHECK(c.resolved["metric"]["max_aspect"] == "automatic");
  CHECK(c.metric.automatic_aspect);
}

TEST_CASE("aspects are bounded automatically for solutions only, and as far as no number is given", "[adapt][case]") {
  const auto with = [](const std::string& problem, const std::string& metric) {
    return parse_case(case_text(problem, R"(, "metric": {)" + metric + "}"), "a.json");
  };
  const std::string heat = R"("source": 1, "boundary": {"*": {"dirichlet": 0}})";
  const std::string given = R"("interpolate": "x^2")";
  CHECK(with(heat, R"("max_aspect": "automatic")").metric.automatic_aspect);
  CHECK_FALSE(with(heat, R"("max_aspect": "2*50")").metric.automatic_aspect);
  CHECK(with(heat, R"("max_aspect": "2*50")").metric.max_aspect == 100.0);
  CHECK_FALSE(with(given, "").metric.automatic_aspect);
  CHECK(with(given, "").resolved["metric"]["max_aspect"] == 1e6);
  CHECK_FALSE(with(given, R"("max_aspect": "automatic")").metric.automatic_aspect);
  CHECK_THROWS_AS(with(heat, R"("max_aspect": "auto")"), CaseError);
  CHECK_THROWS_AS(with(heat, R"("max_aspect": 0.5)"), CaseError);
}

TEST_CASE("A resolved case read again is the same case", "[adapt][case]") {
  for (const std::string& file : case_files()) {
    INFO(file);
    const Case c = read_case(file);
    CHECK(parse_case(c.resolved.dump(), file).resolved == c.resolved);
  }
}

TEST_CASE("Every case in cases/ is right and is named as its file", "[adapt][case]") {
  REQUIRE(case_files().size() >= 7);
  for (const std::string& file : case_files()) {
    INFO(file);
    const Case c = read_case(file);
    CHECK(c.name == std::filesystem::path(file).stem().string());
    CHECK_FALSE(c.title.empty());
    CHECK_FALSE(c.expect.empty());
    CHECK((c.interpolation || !c.problem.boundary.empty()));
  }
}

TEST_CASE("parse_case reads every option", "[adapt][case]") {
  const Case c = parse_case(case_text(R"("interpolate": "x^2*a")", R"(, "name": "n-1", "title": "T",
      "parameters": {"a": 2, "b": "a^2 + 1", "x-note": "mine"}, // a comment
      "metric": {"kind": "loseille-alauzet", "norm": "inf", "recovery": "exact", "h_min": "1/b", "h_max": 0.5,
                 "max_aspect": 10, "gradation": 1.5},
      "targets": {"l2_error": "1e-3/a", "h1_error": 2, "linf_error": 3, "vertices": 50, "max_vertices": 60.0,
                  "max_iterations": 3, "max_seconds": 1.5},
      "mesher": {"schedule": "fast", "preset": "mid", "seed": 9}, "initial": {"vertices": 77},
      "output": {"formats": ["svg"]}, /* and another */
      "expect": {"efficiency": {"max": 1.1}, "targets_met": true, "x-why": 1}, "x-own": [[1]])"),
                            "a.json");
  CHECK(c.interpolation);
  CHECK(c.exact->value({3.0, 0.0}) == 18.0);
  CHECK(c.metric.kind == MetricKind::LoseilleAlauzet);
  CHECK(std::isinf(c.metric.norm));
  CHECK(c.metric.exact_hessian);
  CHECK(c.metric.h_min == 0.2);
  CHECK(c.metric.gradation == 1.5);
  CHECK(c.targets.l2_error == 0.0005);
  CHECK(c.targets.vertices == 50);
  CHECK(c.targets.max_vertices == 60);
  CHECK(c.targets.max_seconds == 1.5);
  CHECK(c.mesher.preset == Preset::Mid);
  CHECK(c.mesher.seed == 9);
  CHECK(c.initial_vertices == 77);
  CHECK(c.output.formats == std::vector<std::string>{"svg"});
  REQUIRE(c.expect.size() == 2);
  CHECK(c.expect[0].path == std::vector<std::string>{"efficiency"});
  CHECK(c.expect[0].max == 1.1);
  CHECK(c.expect[1].equals == true);
  CHECK(c.resolved["parameters"]["b"] == 5.0);
}

TEST_CASE("mesher.lower_error is read", "[adapt][case]") {
  CHECK(parse_case(case_text(kZeroBoundary, R"(, "mesher": {"lower_error": true})"), "a.json").lower_error);
  // Beside another target an H1 error does not make the metric that of H1.
  CHECK(parse_case(case_text(kZeroBoundary, R"(, "mesher": {"lower_error": true},
      "targets": {"h1_error": 1, "l2_error": 1})"),
                   "a.json")
            .lower_error);
}

TEST_CASE("metrics are interpolated by logarithms, or linearly when the case says so", "[adapt][case]") {
  CHECK(parse_case(case_text(kZeroBoundary), "a.json").metric.interpolation == MetricInterpolation::LogEuclidean);
  CHECK(parse_case(case_text(kZeroBoundary, R"(, "metric": {"interpolation": "linear"})"), "a.json")
            .metric.interpolation == MetricInterpolation::Linear);
}

TEST_CASE("the thesis's schedule and what acts between particles are read", "[adapt][case]") {
  const GenerateOptions plain = parse_case(case_text(kZeroBoundary), "a.json").mesher;
  CHECK(plain.schedule == Schedule::Fast);
  CHECK(plain.particles.potential == ParticleOptions{}.potential);
  CHECK(plain.particles.max_picks == ParticleOptions{}.max_picks);
  const GenerateOptions read = parse_case(case_text(kZeroBoundary, R"(, "mesher": {"schedule": "thesis", "particles": {
      "potential": "shimada", "neighbourhood": "radius", "radius": 1.8, "force": "gradient",
      "distance": "linear-metric", "step": 0.1, "momentum": 0.5, "alive_speed": 0.02, "virtual_triangles": false,
      "creation": "circumcentre", "annihilation": "collapse", "relocation": "in-place", "picking": "hilbert",
      "max_picks": 50}})"),
                                          "a.json")
                                   .mesher;
  CHECK(read.schedule == Schedule::Thesis);
  CHECK(read.particles.potential == PotentialKind::Shimada);
  CHECK(read.particles.neighbourhood == Neighbourhood::Radius);
  CHECK(read.particles.radius == 1.8);
  CHECK(read.particles.force == Force::Gradient);
  CHECK(read.particles.distance == EdgeDistance::LinearMetric);
  CHECK(read.particles.step == 0.1);
  CHECK(read.particles.momentum == 0.5);
  CHECK(read.particles.alive_speed == 0.02);
  CHECK_FALSE(read.particles.virtual_triangles);
  CHECK(read.particles.creation == CreationPlace::Circumcentre);
  CHECK(read.particles.annihilation == Annihilation::Collapse);
  CHECK(read.particles.relocation == Relocation::InPlace);
  CHECK(read.particles.picking == Picking::Hilbert);
  CHECK(read.particles.max_picks == 50.0);
  CHECK_THAT(issue_text(case_text(kZeroBoundary, R"(, "mesher": {"particles": {"potential": "shimda"}})")),
             Catch::Contains("did you mean 'shimada'"));
  const GenerateOptions fast =
      parse_case(case_text(kZeroBoundary, R"(, "mesher": {"particles": {"neighbourhood": "n2"}})"), "a.json").mesher;
  CHECK(fast.schedule == Schedule::Fast);
  CHECK(fast.particles.neighbourhood == Neighbourhood::N2);
  CHECK_THAT(issue_text(case_text(kZeroBoundary, R"(, "mesher": {"particles": {"picking": "hilbert"}})")),
             Catch::Contains("/mesher/particles/picking") && Catch::Contains("schedule"));
}

TEST_CASE("options of the mesher that would not be read are refused", "[adapt][case][errors]") {
  const auto issues = [](const std::string& mesher) {
    return issue_text(case_text(kZeroBoundary, R"(, "mesher": )" + mesher));
  };
  CHECK(issues(R"({"particles": {"decay": 2}})").empty());
  CHECK_THAT(issues(R"({"particles": {"potential": "shimada", "decay": 2}})"),
             Catch::StartsWith("/mesher/particles/decay: is for the potential"));
  CHECK(issues(R"({"particles": {"neighbourhood": "radius", "radius": 1.8}})").empty());
  CHECK_THAT(issues(R"({"particles": {"radius": 1.8}})"), Catch::StartsWith("/mesher/particles/radius: is for"));
  CHECK(issues(R"({"schedule": "thesis", "preset": "mid"})").empty());  // a case is tried with either schedule
}

TEST_CASE("Overrides replace and add values by JSON pointer", "[adapt][case]") {
  const Case c = parse_case(case_text(kZeroBoundary, R"(, "targets": {"max_iterations": 4})"), "a.json",
                            {{"/targets/max_iterations", "7"},
                             {"/parameters/alpha", "3"},
                             {"/problem/source", "alpha*x"},
                             {"/geometry/rectangle/max/0", "2"},
                             {"/name", "other"}});
  CHECK(c.targets.max_iterations == 7);
  CHECK(c.problem.source({2.0, 0.0}, 0) == 6.0);
  CHECK(c.domain.points[1] == Point{2.0, 0.0});
  CHECK(c.name == "other");
  CHECK(issue_text(case_text(kZeroBoundary), {{"targets", "1"}}) ==
        "targets: (from --set) not a JSON pointer to set; write for example /targets/max_iterations=5\n");
  CHECK_THAT(issue_text(case_text(kZeroBoundary), {{"/geometry/rectangle/min/7", "1"}}), Catch::Contains("nothing"));
  CHECK_THAT(issue_text(case_text(kZeroBoundary), {{"/targets/l2_errr", "1"}}),
             Catch::Contains("did you mean 'l2_error'"));
}

TEST_CASE("What an override sets is UTF-8", "[adapt][case][errors]") {
  const std::string text = case_text(kZeroBoundary);
  CHECK_THAT(issue_text(text, {{"/title", "\xe4"}}),
             Catch::Contains("/title: (from --set) has bytes that are not UTF-8"));
  CHECK_THAT(issue_text(text, {{"/x-\xe4", "1"}}), Catch::Contains("has bytes that are not UTF-8"));
  CHECK(parse_case(text, "a.json", {{"/title", "\xc3\xa4"}}).title == "\xc3\xa4");
}

TEST_CASE("case_schema is a JSON Schema that refers only to what it defines", "[adapt][case]") {
  const nlohmann::ordered_json schema = case_schema();
  CHECK(schema["$schema"] == "https://json-schema.org/draft/2020-12/schema");
  const std::string text = schema.dump();
  std::size_t num_references = 0;
  for (std::size_t at = text.find("#/$defs/"); at != std::string::npos; at = text.find("#/$defs/", at + 1)) {
    const std::string name = text.substr(at + 8, text.find('"', at) - at - 8);
    INFO(name);
    CHECK(schema["$defs"].contains(name));
    ++num_references;
  }
  CHECK(num_references > 40);
}

}  // namespace parmesan
