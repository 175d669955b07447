#include <catch2/catch.hpp>

#include "tests/system/program.h"

using parmesan::support::ProgramResult;
using parmesan::support::run_program;

TEST_CASE("help and version go to standard output and end with 0", "[system][usage]") {
  const std::vector<std::string> arguments =
      GENERATE(std::vector<std::string>{"--help"}, std::vector<std::string>{"--version"},
               std::vector<std::string>{"run", "--help"}, std::vector<std::string>{"compare", "--help"},
               std::vector<std::string>{"mesh", "--help"}, std::vector<std::string>{"quality", "--help"},
               std::vector<std::string>{"check", "--help"}, std::vector<std::string>{"schema", "--help"},
               std::vector<std::string>{"convert", "--help"}, std::vector<std::string>{"report", "--help"});
  const ProgramResult result = run_program(arguments);
  CHECK(result.exit_code == 0);
  CHECK(result.err.empty());
  CHECK_THAT(result.out, Catch::Contains(arguments.front() == "--version" ? "compiler" : "--help"));
}

TEST_CASE("every subcommand tells its version and takes a seed, if only to say that it is idle", "[system][usage]") {
  const std::string name = GENERATE("run", "compare", "mesh", "quality", "check", "schema", "convert", "report");
  CHECK_THAT(run_program({name, "--version"}).out, Catch::StartsWith("parmesan ") && Catch::Contains("compiler"));
  CHECK_THAT(run_program({name, "--help"}).out, Catch::Contains("--seed N"));
  if (name == "schema") CHECK_THAT(run_program({name, "--seed", "3"}).err, Catch::Contains("--seed has no effect"));
}

TEST_CASE("each subcommand's help shows an example", "[system][usage]") {
  const std::string name = GENERATE("run", "compare", "mesh", "quality", "check", "schema", "convert", "report");
  CHECK_THAT(run_program({name, "--help"}).out, Catch::Contains("Example: parmesan " + name));
}

TEST_CASE("wrong usage ends with 2 and one message on standard error", "[system][usage][errors]") {
  const std::vector<std::string> arguments = GENERATE(
      std::vector<std::string>{}, std::vector<std::string>{"meshh"}, std::vector<std::string>{"run"},
      std::vector<std::string>{"run", "a.json", "--no-such-option"}, std::vector<std::string>{"mesh", "a.poly"},
      std::vector<std::string>{"mesh", "a.poly", "-o", "a.mesh", "--size", "-1"},
      std::vector<std::string>{"mesh", "a.poly", "-o", "a.mesh", "--size", "1", "--background", "b.mesh"},
      std::vector<std::string>{"mesh", "a.poly", "-o", "a.mesh", "--size", "1", "--preset", "best"},
      std::vector<std::string>{"mesh", "a.poly", "-o", "a.mesh", "--size", "1", "--require", "beauty=1"},
      std::vector<std::string>{"mesh", "a.poly", "-o", "a.mesh", "--size", "1", "--limit", "vertices=many"},
      std::vector<std::string>{"run", "a.json", "--set", "targets"},
      std::vector<std::string>{"run", "a.json", "--threads", "0"},
      std::vector<std::string>{"report", "a.out", "-o", "-"}, std::vector<std::string>{"run", "a.json", "-o", "-"},
      std::vector<std::string>{"compare", "a.json", "--sizes", "10,x"});
  const ProgramResult result = run_program(arguments);
  CHECK(result.exit_code == 2);
  CHECK(result.out.empty());
  CHECK_THAT(result.err, Catch::StartsWith("parmesan: error: "));
  CHECK_THAT(result.err, Catch::Contains("--help"));
}

TEST_CASE("a wrong name on the command line gets the nearest one, and the list of those that are short",
          "[system][usage][errors]") {
  struct Slip {
    std::vector<std::string> arguments;
    std::string message;
  };
  const std::vector<std::string> mesh{"mesh", "a.poly", "-o", "a.mesh"};
  const auto mesh_with = [&mesh](const std::string& option, const std::string& value) {
    std::vector<std::string> all = mesh;
    all.insert(all.end(), {option, value});
    return all;
  };
  const Slip slip = GENERATE_COPY(values<Slip>({
      {mesh_with("--preset", "godo"), "--preset: 'godo' is none of 'fast', 'mid', 'good'; did you mean 'good'?"},
      {mesh_with("--preset", "2"), "--preset: '2' is none of 'fast', 'mid', 'good'\n"},
      {mesh_with("--potential", "lenard-jones"), "'ratio-error'; did you mean 'lennard-jones'?"},
      {mesh_with("--schedule", "theses"), "'thesis'; did you mean 'thesis'?"},
      {mesh_with("--limit", "vertexes=3"), "'seconds'; did you mean 'vertices'?"},
      {mesh_with("--require", "units=x"), "'quality'; did you mean 'unit'?"},
      {mesh_with("--voronio", "a.svg"), "unknown option '--voronio'; did you mean '--voronoi'?"},
      {{"mesh", "a.poly", "--siez=0.1"}, "unknown option '--siez'; did you mean '--size'?"},  // not: --out is missing
      {{"mehs", "a.poly", "-o", "a.mesh"}, "'mehs' is none of 'run', 'compare', 'mesh'"},
      {{"mehs", "a.poly"}, "did you mean 'mesh'?"},
      {{"--threads", "2", "mesh", "a.poly", "-o", "a.mesh"}, "'--threads' is an option of 'mesh' and comes after it"},
      {{"-q", "mesh", "a.poly", "-o", "a.mesh"}, "'-q' is an option of 'mesh' and comes after it"},
      {{"--limit=seconds=9", "run"}, "'--limit' is an option of 'run' and comes after it"},
      {{"--thraeds=2", "run", "a.json"}, "unknown option '--thraeds'; did you mean '--threads'?"},
      {{"--versoin"}, "unknown option '--versoin'; did you mean '--version'?"},
  }));
  const ProgramResult result = run_program(slip.arguments);
  INFO(result.err);
  CHECK(result.exit_code == 2);
  CHECK_THAT(result.err, Catch::Contains(slip.message));
}

TEST_CASE("an empty name is refused, not taken for one that is not given", "[system][usage][errors]") {
  struct Empty {
    std::vector<std::string> arguments;
    std::string name;
  };
  const Empty empty = GENERATE(values<Empty>({
      {{"run", "a.json", "--out", ""}, "--out"},
      {{"compare", "a.json", "-o", ""}, "--out"},
      {{"report", "a.out", "-o", ""}, "--out"},
      {{"mesh", "a.poly", "-o", "a.mesh", "--from", ""}, "--from"},
      {{"mesh", "a.poly", "-o", "a.mesh", "--evolution", ""}, "--evolution"},
      {{"convert", "", "a.mesh"}, "IN"},
      {{"check", "a.json", ""}, "CASE"},
  }));
  const ProgramResult result = run_program(empty.arguments);
  INFO(result.err);
  CHECK(result.exit_code == 2);
  CHECK_THAT(result.err, Catch::StartsWith("parmesan: error: " + empty.name + ": is empty"));
}

TEST_CASE("control characters of names do not reach the terminal", "[system][usage][errors]") {
  const ProgramResult result = run_program({"check",
                                            "no\x1b[31msuch\x07"
                                            "file.json"});
  CHECK(result.exit_code == 7);
  CHECK(result.err.find('\x1b') == std::string::npos);
  CHECK(result.err.find('\x07') == std::string::npos);
  CHECK_THAT(result.err, Catch::Contains("\\x1b"));
}
