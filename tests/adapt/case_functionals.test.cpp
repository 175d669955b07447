#include <catch2/catch.hpp>
#include <cmath>

#include "adapt/functional_value.h"
#include "adapt/iterate.h"
#include "adapt/measure.h"
#include "adapt/run_case.h"
#include "tests/adapt/case_support.h"

namespace parmesan {
namespace {

using namespace support;

/// Two materials in series, K = 40 left of x = 1 and 1 right of it; u falls from 41 to 0, by 1 and by 40.
std::string series(const std::string& rest) {
  return R"({"name": "series", "geometry": {"rectangle": {"min": [0, 0], "max": [2, 1]},
      "regions": {"steel": [0.5, 0.5], "air": [1.5, 0.5]}, "segments": [{"from": [1, 0], "to": [1, 1]}]},
    "problem": {"diffusion": {"steel": 40, "*": 1}, "boundary": {
      "left": {"dirichlet": 41}, "right": {"dirichlet": 0}, "*": {"neumann": 0}}},
    "initial": {"vertices": 60}, "targets": {"vertices": 60, "max_iterations": 1}, "mesher": {"preset": "fast"})" +
         rest + "}";
}

IterationRow first_row(const Case& c) {
  Iterate iterate = uniform_iterate(c, 60);
  compute_values(c, iterate, nullptr);
  return measure(c, iterate, 0, std::nullopt);
}

}  // namespace

TEST_CASE("Functionals of a case are integrals, fluxes and values of its solution", "[adapt][case][functional]") {
  const Case c = parse_case(series(R"(, "functionals": {
      "heat": {"flux": "right"}, "warm": {"integral": "steel"}, "all": {"integral": "*"},
      "moment": {"integral": "air", "weight": "x - 1"}, "wall": {"boundary_integral": "top"},
      "centre": {"value": [1, 0.5]}})"),
                            "case.json");
  IterationRow row = first_row(c);
  // u = 41 - x left, 40 (2 - x) right: the flux is -40 everywhere.
  CHECK(row.functionals.at("heat") == Approx(-40).epsilon(1e-11));
  CHECK(row.functionals.at("warm") == Approx(40.5).epsilon(1e-11));
  CHECK(row.functionals.at("all") == Approx(60.5).epsilon(1e-11));
  CHECK(row.functionals.at("moment") == Approx(40.0 / 6).epsilon(1e-11));
  CHECK(row.functionals.at("wall") == Approx(60.5).epsilon(1e-11));
  CHECK(row.functionals.at("centre") == Approx(40).epsilon(1e-11));
  CHECK(row.fluxes.at("left") == Approx(40).epsilon(1e-11));
  CHECK(row.fluxes.at("top") == 0.0);
  CHECK(*row.solve_report->bounds.upper == 41.0);
  const nlohmann::ordered_json json = to_json(row);
  CHECK(json["functionals"]["centre"].get<double>() == row.functionals.at("centre"));
  CHECK(json["solver"]["backward_error"].get<double>() < 1e-10);
  CHECK(json["bounds"]["overshoot"] == 0.0);
}

TEST_CASE("An integral over the boundary is not changed by lines inside, and has both sides of cracks",
          "[adapt][case][functional]") {
  // u = 2 on four sides of length 1, and on both of a crack of length 1/4.
  const auto boundary_integral = [](const std::string& label_right) {
    const Case c = parse_case(R"({"geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]},
        "segments": [{"from": [0.5, 0.25], "to": [0.5, 0.5], "label": "line")" +
                                  label_right + R"(}]},
        "problem": {"exact": 2, "boundary": {"*": {"dirichlet": "exact"}}},
        "functionals": {"all": {"boundary_integral": "*"}, "line": {"boundary_integral": "line"}}})",
                              "case.json");
    const IterationRow row = first_row(c);
    CHECK(row.functionals.at("line") == Approx(0.5).epsilon(1e-11));
    return row.functionals.at("all");
  };
  CHECK(boundary_integral("") == Approx(8.0).epsilon(1e-11));
  CHECK(boundary_integral(R"(, "label_right": "right of it")") == Approx(9.0).epsilon(1e-11));
}

TEST_CASE("Point sources are counted once, also where the source is derived from their potential",
          "[adapt][case][functional]") {
  const std::string source = GENERATE(as<std::string>{}, "", R"("source": 0, )", R"("velocity": [0, 0], )");
  const Case c = parse_case(R"({"geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}}, "problem": {)" + source +
                                R"case("exact": "-log(hypot(x - 0.4, y - 0.6))/(2*pi)",
      "point_sources": [{"at": [0.4, 0.6], "strength": 1}], "boundary": {"*": {"dirichlet": "exact"}}},
      "initial": {"vertices": 60}, "mesher": {"preset": "fast"}})case",
                            "case.json");
  const IterationRow row = first_row(c);
  double sum = 0.0;
  for (const auto& [label, flux] : row.fluxes) sum += flux;
  CHECK(sum == Approx(-1.0).epsilon(1e-3));  // what the source discharges flows out
}

TEST_CASE("The flux into a side that lies inside without a condition is refused", "[adapt][case][functional][errors]") {
  const std::string functional = R"(, "functionals": {"through": {"flux": "inside"}})";
  std::string text = series(functional);
  CHECK_THROWS_WITH(parse_case(text, "case.json"),
                    Catch::Contains("/functionals/through/flux") && Catch::Contains("lies inside of the domain"));
  const std::string wall = R"("inside": {"dirichlet": 7}, )";
  text.insert(text.find(R"("left": {"dirichlet")"), wall);
  CHECK_NOTHROW(parse_case(text, "case.json"));
}

TEST_CASE("Limits on functionals and fluxes are verified", "[adapt][case][functional]") {
  const Case c = parse_case(series(R"(, "functionals": {"warm": {"integral": "steel"}},
      "expect": {"functionals": {"warm": {"min": 40, "max": 40.4}}, "fluxes": {"right": {"max": -39}}})"),
                            "case.json");
  Summary summary;
  summary.iterations.push_back(first_row(c));
  const std::vector<Verdict> verdicts = verify(c.expect, summary);
  REQUIRE(verdicts.size() == 2);
  CHECK_FALSE(verdicts[0].passed);
  CHECK(verdicts[0].name == "functionals.warm");
  CHECK(verdicts[1].passed);
}

TEST_CASE("Limits are on functionals and fluxes of any name, but one that there is", "[adapt][case][functional]") {
  const std::string name = GENERATE("right.hand", "inner/upper", "a~b", "~1");
  const auto text = [&](const std::string& limited) {
    std::string result =
        series(R"(, "functionals": {")" + name + R"(": {"flux": ")" + name + R"("}}, "expect": {"functionals": {")" +
               limited + R"(": {"max": -39}}, "fluxes": {")" + limited + R"(": {"max": -39}}})");
    const std::string rectangle = R"("rectangle": {"min": [0, 0], "max": [2, 1]})";
    result.insert(result.find(rectangle), R"("labels": {"right": ")" + name + R"("}, )");
    return result.replace(result.find(R"("right": {"dirichlet")"), 7, "\"" + name + "\"");
  };
  const Case c = parse_case(text(name), "case.json");
  Summary summary;
  summary.iterations.push_back(first_row(c));
  for (const Verdict& verdict : verify(c.expect, summary)) {
    INFO(verdict.message);
    CHECK(verdict.passed);
  }
  const std::string issues = issue_text(text("rigt"));
  CHECK_THAT(issues, Catch::Contains("/expect/functionals/rigt: 'rigt' is none of the functionals"));
  CHECK_THAT(issues, Catch::Contains("/expect/fluxes/rigt: 'rigt' is none of the fluxes"));
}

TEST_CASE("Point sources of a case are sources of its problem", "[adapt][case]") {
  const Case c =
      parse_case(case_text(R"("point_sources": [{"at": [0.5, 0.25], "strength": 2}], )" + kZeroBoundary), "case.json");
  REQUIRE(c.problem.point_sources.size() == 1);
  CHECK(c.problem.point_sources[0].place == Point{0.5, 0.25});
  CHECK(c.problem.point_sources[0].strength == 2.0);
}

TEST_CASE("Functionals that cannot be are refused with what there is", "[adapt][case][functional][errors]") {
  const auto issue = [](const std::string& functional) {
    return issue_text(series(R"(, "functionals": {"f": )" + functional + "}"));
  };
  CHECK(issue(R"({"integral": "stel"})") ==
        "/functionals/f/integral: the geometry has no region 'stel'; did you mean 'steel'? There are: 'air', 'steel', "
        "and \"*\" stands for all\n");
  CHECK_THAT(issue(R"({"flux": "bottm"})"), Catch::Contains("no side 'bottm'; did you mean 'bottom'?"));
  CHECK_THAT(issue(R"({"flux": "left", "value": [0, 0]})"), Catch::Contains("found 'flux', 'value'"));
  CHECK_THAT(issue(R"({"flux": "left", "weight": "x"})"),
             Catch::Contains("/functionals/f/weight: is for 'integral' and 'boundary_integral' only"));
  CHECK_THAT(issue(R"({"integral": "*", "weight": "z"})"), Catch::Contains("unknown name 'z'"));
  CHECK_THAT(issue_text(case_text(R"("interpolate": "x")", R"(, "functionals": {"f": {"flux": "left"}})")),
             Catch::Contains("has no flux"));
  CHECK_THAT(issue_text(case_text(R"("point_sources": [{"at": [0, 0]}], )" + kZeroBoundary)),
             Catch::Contains("/problem/point_sources/0: the key 'strength' is missing"));
}

}  // namespace parmesan
