#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "adapt/case.h"
#include "case_support.h"

namespace parmesan {
namespace {

using support::case_text;
using support::issue_text;
using support::issues_of;
using support::kZeroBoundary;

/// Issues of a right case with these further sections.
std::string issues_with(const std::string& rest) { return issue_text(case_text(kZeroBoundary, rest)); }

std::string what_of(const std::string& text) {
  try {
    parse_case(text, "cases/mine.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("All issues of a case are reported at once, with place, remedy and nearest name", "[adapt][case][errors]") {
  const std::string text = R"json({
  "name": "mine",
  "geometry": { "rectangle": { "min": [0, 0], "max": [1, 1] } },
  "problem": {
    "exact": "sin(pi*x)*y + alfa",
    "boundary": { "left": { "dirichlet": "exact" }, "rigth": { "dirichlet": 1 } }
  },
  "parameters": { "alpha": 1 },
  "targets": { "l2_eror": 1e-4, "max_iterations": "many" },
  /* über */ "mesher": { "preset": "god" }
}
)json";
  CHECK(what_of(text) ==
        "cases/mine.json:5:29: /problem/exact: unknown name 'alfa'; did you mean 'alpha'? Allowed here: 'x', 'y', "
        "'pi', 'alpha' and functions such as sqrt, exp, sin (character 15 of the expression)\n"
        "cases/mine.json:6:5: /problem/boundary: no condition for the sides 'bottom', 'right', 'top'; give one for "
        "each, or for \"*\" (all others)\n"
        "cases/mine.json:6:53: /problem/boundary/rigth: the geometry has no side 'rigth'; did you mean 'right'? Its "
        "sides are: 'bottom', 'right', 'top', 'left', and \"*\" stands for all others\n"
        "cases/mine.json:9:16: /targets/l2_eror: unknown key 'l2_eror'; did you mean 'l2_error'? Allowed here: "
        "'l2_error', 'h1_error', 'linf_error', 'goal_error', 'goal', 'vertices', 'max_vertices', 'max_iterations', "
        "'max_seconds'\n"
        "cases/mine.json:9:33: /targets/max_iterations: must be a whole number of at least 1 and at most 10000, not "
        "the text 'many'\n"
        "cases/mine.json:10:26: /mesher/preset: must be one of 'fast', 'mid', 'good', not the text 'god'; did you mean "
        "'good'?");
}

TEST_CASE("A case that is not JSON, or not within the limits, is refused with its place", "[adapt][case][errors]") {
  CHECK_THAT(what_of("{\n  \"name\": ,\n}"), Catch::StartsWith("cases/mine.json:2:11: not JSON: "));
  CHECK_THAT(what_of(""), Catch::Contains("not JSON"));
  CHECK_THAT(what_of("[1]"), Catch::Contains("a case is an object"));
  CHECK_THAT(what_of("{\"a\":\n  1e999}"), Catch::StartsWith("cases/mine.json:2:3: not JSON: number overflow"));
  CHECK_THAT(what_of("\n" + std::string(100000, '[')),
             Catch::StartsWith("cases/mine.json:2:65: nested more than 64 deep"));
  CHECK_THAT(what_of(std::string("{}\0}, {", 7)), Catch::StartsWith("cases/mine.json:1:3: not JSON: a NUL"));
  CHECK_THAT(what_of(std::string((std::size_t{64} << 20) + 1, ' ')), Catch::Contains("larger than 64 MiB"));
  CHECK_THAT(what_of("{\"name\": \"\xff\"}"), Catch::Contains("not JSON"));
  CHECK_THAT(what_of("{\"na\x1b[31mme\": 1}"), Catch::Contains("not JSON"));
  CHECK_THAT(what_of("{\"na\\u001b[31mme\": 1}"), Catch::Contains("unknown key 'na?[31mme'"));
}

TEST_CASE("Repeated keys are refused with both places", "[adapt][case][errors]") {
  CHECK(issues_of(case_text(kZeroBoundary, ",\n\"targets\": {\"vertices\": 4,\n \"vertices\": 5}")) ==
        std::vector<std::string>{"/targets/vertices: the key is given twice; the second time in line 3, column 2"});
}

TEST_CASE("Repeated keys in what --set gives are refused too", "[adapt][case][errors]") {
  const std::vector<Override> twice{{"/targets", R"({"vertices": 4, "vertices": 5})"}};
  CHECK(issues_of(case_text(kZeroBoundary), twice) ==
        std::vector<std::string>{"/targets/vertices: (from --set) the key is given twice; the second time in line 1, "
                                 "column 17 of the value"});
  const std::vector<Override> text{{"/title", R"({"a": 4, "a": 5)"}};  // no JSON
  CHECK(issues_of(case_text(kZeroBoundary), text).empty());
}

TEST_CASE("An object has a limited number of names, since each is looked for among the others",
          "[adapt][case][errors]") {
  const auto with_names = [](int count) {
    std::string text = "{\"name\": \"a\"";
    for (int k = 1; k < count; ++k) text += ",\n\"x-" + std::to_string(k) + "\": 0";
    return text + "}";
  };
  CHECK_THAT(what_of(with_names(2001)), Catch::Contains(":2001:1: an object has more than 2000 names"));
  CHECK_THAT(what_of(with_names(2000)), Catch::Contains("the key 'geometry' is missing"));
}

TEST_CASE("Whole numbers beyond 2^53 are refused wherever they stand", "[adapt][case][errors]") {
  const std::string large = "9007199254740993";
  const auto refused = [](const std::string& text, const std::string& pointer) {
    CHECK_THAT(issue_text(text), Catch::Contains(pointer + ": whole numbers beyond 2^53"));
  };
  refused(case_text(kZeroBoundary, R"(, "parameters": {"a": )" + large + "}"), "/parameters/a");
  refused(case_text(R"("boundary": {"*": {"neumann": -)" + large + "}}"), "/problem/boundary/*/neumann");
  refused(case_text(kZeroBoundary, R"(, "expect": {"vertices": {"max": )" + large + "}}"), "/expect/vertices/max");
  refused(case_text(R"("boundary": {"*": {"dirichlet": )" + large + "}}"), "/problem/boundary/*/dirichlet");
  CHECK(issues_with(R"(, "parameters": {"a": 9007199254740992, "b": -9007199254740992, "c": 1e30})").empty());
}

TEST_CASE("A list of what is allowed is as long as one can read", "[adapt][case][errors]") {
  std::string many = R"(, "targets": {"l2_error": "p"}, "parameters": {)";
  for (int k = 0; k < 1900; ++k) many += (k > 0 ? ", \"q" : "\"q") + std::to_string(k) + "\": 1";
  const std::string issues = issues_with(many + ", \"" + std::string(100000, 'z') + "\": 1}");
  CHECK(issues.size() < 5000);
  CHECK_THAT(issues, Catch::Contains("unknown name 'p'") && Catch::Contains(" more"));
}

TEST_CASE("Values of the wrong kind or range are refused, saying what is allowed", "[adapt][case][errors]") {
  CHECK(issues_with(R"(, "targets": {"l2_error": -1})") ==
        "/targets/l2_error: must be a number or an expression of the parameters above 0, not -1\n");
  CHECK(issues_with(R"(, "targets": {"l2_error": "x"})") ==
        "/targets/l2_error: must be a number or an expression of the parameters; it must not depend on x or y\n");
  CHECK(issues_with(R"(, "targets": {"l2_error": "1/0"})") ==
        "/targets/l2_error: the expression '1/0' is not finite: inf\n");
  CHECK(issues_with(R"(, "targets": {"max_iterations": 2.5})") ==
        "/targets/max_iterations: must be a whole number of at least 1 and at most 10000, not the number 2.5\n");
  CHECK(issues_with(R"(, "mesher": {"preset": "god"})") ==
        "/mesher/preset: must be one of 'fast', 'mid', 'good', not the text 'god'; did you mean 'good'?\n");
  CHECK(issues_with(R"(, "mesher": {"lower_error": 1})") ==
        "/mesher/lower_error: must be true or false, not the number 1\n");
  CHECK(issues_with(R"(, "mesher": {"lower_error": true}, "metric": {"norm": 4})") ==
        "/mesher/lower_error: lowers the L2 error only: needs the norm 2 in metric.norm\n");
  CHECK(issues_with(R"(, "mesher": {"lower_error": true}, "targets": {"h1_error": 1})") ==
        "/mesher/lower_error: lowers the L2 error only: of no use to the one target 'h1_error'\n");
  CHECK(issues_with(R"(, "mesher": {"lower_error": false}, "metric": {"norm": 4})").empty());
  CHECK(issues_with(R"(, "metric": {"max_aspect": "auto"})") ==
        "/metric/max_aspect: must be one of 'automatic', or a number or an expression of the parameters of at least 1, "
        "not "
        "the text 'auto'; did you mean 'automatic'?\n");
  CHECK(issues_with(R"(, "parameters": {"auto": 5}, "metric": {"max_aspect": "auto"})").empty());
  CHECK(issues_with(R"(, "initial": {"continuation": 0.5})") ==
        "/initial/continuation: must be a number or an expression of the parameters of at least 1 and at most 1e+12, "
        "not 0.5\n");
  CHECK(issues_with(R"(, "mesher": {"seed": 9007199254740993})") ==
        "/mesher/seed: whole numbers beyond 2^53 = 9007199254740992 cannot be kept exactly\n");
  CHECK_THAT(issues_with(R"(, "initial": {"vertices": 1e300})"), Catch::Contains("2^53"));
  CHECK(issues_with(R"(, "metric": {"norm": "if"})") ==
        "/metric/norm: must be a number of at least 1, or one of 'inf', not the text 'if'; did you mean 'inf'?\n");
  CHECK(issues_with(R"(, "metric": {"norm": 0.5})") == "/metric/norm: must be a number of at least 1, not 0.5\n");
  CHECK(issues_with(R"(, "metric": [])") == "/metric: must be an object { }, not a list of 0\n");
  CHECK(issues_with(R"(, "title": null)") == "/title: must be a text, not null\n");
  CHECK(issues_with(R"(, "output": {"formats": ["vtk"]})") ==
        "/output/formats/0: must be one of 'vtu', 'mesh', 'msh', 'svg', 'png', not the text 'vtk'; did you mean "
        "'vtu'?\n");
  CHECK_THAT(issues_with(R"(, "name": "../../etc")"), Catch::Contains("must name a folder"));
  CHECK_THAT(issues_with(R"(, "name": "")"), Catch::Contains("must name a folder"));
  CHECK_THAT(issues_with(R"(, "metric": {"gradation": 0.9})"), Catch::Contains("above 1"));
  CHECK_THAT(issues_with(R"(, "metric": {"h_min": 2, "h_max": 1})"), Catch::Contains("larger than 'h_max'"));
  CHECK_THAT(issues_with(R"(, "metric": {"recovery": "exact"})"), Catch::Contains("needs the exact solution"));
  CHECK_THAT(issues_with(R"(, "targets": {"vertices": 9, "max_vertices": 8})"), Catch::Contains("larger"));
  CHECK(issues_with(R"(, "expect": {"efficiency": {"min": 2, "max": 1}})") ==
        "/expect/efficiency/min: must not be larger than 'max'\n");
  CHECK(issues_with(R"(, "expect": {"fluxes": {"left": {"min": 1, "max": -1}}})") ==
        "/expect/fluxes/left/min: must not be larger than 'max'\n");
  CHECK(issues_with(R"(, "expect": {"efficiency": {"min": 1, "max": 1}})").empty());
  CHECK_THAT(issues_with(R"(, "expect": {"efficency": {"max": 1}})"), Catch::Contains("did you mean 'efficiency'"));
  CHECK_THAT(issues_with(R"(, "expect": {"targets_met": {"max": 1}})"), Catch::Contains("true or false"));
  CHECK_THAT(issues_with(R"(, "expect": {"efficiency": true})"), Catch::Contains("\"max\""));
}

TEST_CASE("Parameters must have names of their own and finite values", "[adapt][case][errors]") {
  CHECK_THAT(issues_with(R"(, "parameters": {"x": 1})"), Catch::Contains("has a meaning of its own"));
  CHECK_THAT(issues_with(R"(, "parameters": {"sin": 1})"), Catch::Contains("has a meaning of its own"));
  CHECK_THAT(issues_with(R"(, "parameters": {"2a": 1})"), Catch::Contains("starts with a letter"));
  CHECK_THAT(issues_with(R"(, "parameters": {"a": "b", "b": 1})"), Catch::Contains("unknown name 'b'"));
  CHECK_THAT(issues_with(R"(, "parameters": {"a": "1/0"})"), Catch::Contains("not finite"));
  CHECK_THAT(issues_with(R"(, "parameters": {"a": "x"})"), Catch::Contains("must not depend"));
  CHECK_THAT(issues_with(R"(, "parameters": {"a": [1]})"), Catch::Contains("not a list of 1"));
}

TEST_CASE("The number of issues shown is limited", "[adapt][case][errors]") {
  std::string many = ", \"metric\": {";
  for (int i = 0; i < 1900; ++i) many += (i > 0 ? ", \"k" : "\"k") + std::to_string(i) + "\": 1";
  const std::vector<std::string> issues = issues_of(case_text(kZeroBoundary, many + "}"));
  CHECK(issues.size() == 101);
  CHECK(issues.back() == ": only the first issues are shown");
}

TEST_CASE("read_case reads regular files only", "[adapt][case][errors]") {
  CHECK_THROWS_AS(read_case("/no/such/file.json"), FileError);
  CHECK_THROWS_AS(read_case("/dev/zero"), FileError);
  CHECK_THROWS_AS(read_case(PARMESAN_SOURCE_DIR), FileError);
}

}  // namespace parmesan
