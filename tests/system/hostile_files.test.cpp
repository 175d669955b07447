#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/system/program.h"

using parmesan::support::content_of;
using parmesan::support::ProgramResult;
using parmesan::support::run_other;
using parmesan::support::run_program;
using parmesan::support::TemporaryFolder;

// What a stranger may have put into a case, a mesh or a folder: it reaches neither the terminal nor other files.
namespace {

namespace fs = std::filesystem;

const std::string unit_square = R"("geometry": {"rectangle": {"min": [0, 0], "max": [1, 1]}})";

const std::string small_run = R"json({"name": "small", )json" + unit_square + R"json(,
  "problem": {"exact": "x^2*y", "boundary": {"*": {"dirichlet": "exact"}}},
  "targets": {"vertices": 120, "max_iterations": 2}, "initial": {"vertices": 100}, "mesher": {"preset": "fast"},
  "output": {"formats": ["vtu", "mesh", "msh", "svg", "png"]}})json";

/// Ways to hand the program a file of this name.
std::vector<std::vector<std::string>> readers(const std::string& name) {
  if (name.ends_with(".sol")) return {{"convert", name, "out.sol"}};
  if (name.ends_with(".json")) return {{"run", name}, {"check", name}, {"mesh", name, "-o", "out.mesh"}};
  std::vector<std::vector<std::string>> all{{"mesh", name, "--size", "0.5", "-o", "out.mesh"},
                                            {"convert", name, "out.mesh"}};
  if (name.ends_with("h") || name.ends_with("b")) all.push_back({"quality", name});
  return all;
}

bool has_control_characters(const std::string& text) {
  for (const char c : text)
    if ((static_cast<unsigned char>(c) < 0x20 && c != '\n') || c == 0x7f) return true;
  return text.find("\xc2\x9b") != std::string::npos;
}

}  // namespace

TEST_CASE("devices, pipes, folders and secrets are no meshes, and nothing of them is printed",
          "[system][hostile][errors]") {
  const TemporaryFolder folder;
  const std::string suffix = GENERATE(".mesh", ".meshb", ".msh", ".poly", ".dat", ".geojson", ".json", ".node", ".sol");
  const std::string name = "in" + suffix;
  const std::string kind = GENERATE("/dev/zero", "pipe", "folder", "/etc/passwd", "nothing");
  if (kind == "folder") fs::create_directory(folder / name);
  if (kind == "pipe") REQUIRE(run_other("mkfifo", {folder / name}).exit_code == 0);
  if (kind.front() == '/') fs::create_symlink(kind, folder / name);
  for (const std::vector<std::string>& arguments : readers(name)) {
    const ProgramResult result = run_program(arguments, folder.path());
    INFO(arguments.front() << " of " << kind << " as " << name << ": " << result.err);
    CHECK((result.exit_code == 7 || (kind == "/etc/passwd" && result.exit_code == 3)));
    CHECK_THAT(result.err, Catch::StartsWith("parmesan: error: ") && !Catch::Contains("root"));
    CHECK(result.out.empty());
    CHECK_FALSE(fs::exists(folder / "out.mesh"));
  }
}

TEST_CASE("a case reads nothing outside of its folder, also not beside a file it names", "[system][hostile][errors]") {
  const TemporaryFolder folder;
  fs::create_directory(folder / "case");
  folder.write("secret.node", "3 2 0 0\n1 0 0\n2 1 0\n3 0 1\n");
  folder.write("case/a.poly", "0 2 0 0\n3 1\n1 1 2 1\n2 2 3 1\n3 3 1 1\n0\n");
  folder.write("case/case.json", R"({"geometry": {"file": "a.poly"}, "problem": {"interpolate": "x*x"},
    "targets": {"vertices": 100, "max_iterations": 1}})");
  fs::create_symlink(folder / "secret.node", folder / "case/a.node");
  const ProgramResult refused = run_program({"run", folder / "case/case.json", "--out", folder / "out"});
  CHECK(refused.exit_code == 3);
  CHECK_THAT(refused.err,
             Catch::Contains("/geometry/file") && Catch::Contains("a link leads out of the case's folder"));
  fs::remove(folder / "case/a.node");
  fs::copy_file(folder / "secret.node", folder / "case/b.node");
  fs::create_symlink("b.node", folder / "case/a.node");
  CHECK(run_program({"run", folder / "case/case.json", "--out", folder / "out"}).exit_code == 0);
}

TEST_CASE("links in the place of outputs are replaced, and what they lead to stays", "[system][hostile]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("small.json", small_run);
  REQUIRE(run_program({"run", input, "-q", "--out", folder / "out"}).exit_code == 0);
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder / "out"))
    if (entry.is_regular_file()) files.push_back(entry.path());
  REQUIRE(files.size() > 10);
  const std::string treasure = folder.write("treasure", "untouched");
  for (const fs::path& file : files) {
    if (file.parent_path().filename() == "checkpoint") continue;  // links there end a resumption: see below
    fs::remove(file);
    fs::create_symlink(treasure, file);
  }
  const std::string option = GENERATE("--overwrite", "--resume");
  const ProgramResult result = run_program({"run", input, "-q", option, "--out", folder / "out"});
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK(content_of(treasure) == "untouched");
  for (const fs::path& file : files) {
    if (option == "--resume" && file.string().find("iterations") != std::string::npos) continue;  // not written again
    INFO(file);
    CHECK(fs::symlink_status(file).type() == fs::file_type::regular);
  }
}

TEST_CASE("links in the place of an output's folders are not followed", "[system][hostile][errors]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("small.json", small_run);
  REQUIRE(run_program({"run", input, "-q", "--out", folder / "out", "--set", "/targets/max_iterations=1"}).exit_code ==
          0);
  fs::create_directory(folder / "elsewhere");
  const std::string name = GENERATE("iterations", "iterations/001");
  fs::remove_all(folder / ("out/" + name));
  fs::create_directory_symlink(folder / "elsewhere", folder / ("out/" + name));
  const ProgramResult result = run_program({"run", input, "-q", "--resume", "--force", "--out", folder / "out"});
  CHECK(result.exit_code == 7);
  CHECK_THAT(result.err, Catch::Contains("is a link"));
  CHECK(fs::is_empty(folder / "elsewhere"));
  CHECK(run_program({"run", input, "-q", "--overwrite", "--out", folder / "out"}).exit_code == 0);
  CHECK(fs::is_empty(folder / "elsewhere"));
}

TEST_CASE("a case's name is that of one folder below the present one", "[system][hostile][errors]") {
  const TemporaryFolder folder;
  fs::create_directory(folder / "here");
  const std::string name = GENERATE(std::string("../escaped"), std::string("/tmp/escaped"), std::string(".."),
                                    std::string("a/b"), std::string("a\\u0000b"), std::string(300, 'n'));
  const std::string input = folder.write(
      "here/case.json", "{\"name\": \"" + name + "\", " + unit_square + R"(, "problem": {"interpolate": "x*x"}})");
  const ProgramResult result = run_program({"run", input}, folder / "here");
  CHECK(result.exit_code == 3);
  CHECK_THAT(result.err, Catch::Contains("/name: must name a folder"));
  CHECK(std::distance(fs::recursive_directory_iterator(folder.path()), {}) == 2);
}

TEST_CASE("an output of an impossible name ends with 7", "[system][hostile][errors]") {
  const TemporaryFolder folder;
  const std::string input = folder.write("small.json", small_run);
  CHECK(run_program({"run", input, "--out", folder / std::string(300, 'n')}).exit_code == 7);
  CHECK(run_program({"run", input, "--out", folder / std::string(300, 'n'), "--resume"}).exit_code == 7);
  CHECK(run_program({"mesh", input, "--size", "0.5", "-o", folder / (std::string(300, 'n') + ".mesh")}).exit_code == 7);
  CHECK(run_program({"mesh", input, "--size", "0.5", "-o", folder / "none/a.mesh"}).exit_code == 7);
  fs::create_symlink("/dev/full", folder / "full.mesh");
  CHECK(run_program({"mesh", input, "--size", "0.5", "-q", "-o", folder / "full.mesh"}).exit_code == 7);
  CHECK(fs::is_symlink(folder / "full.mesh"));
}

TEST_CASE("names reach terminal and tables without formulas and control characters", "[system][hostile]") {
  const TemporaryFolder folder;
  const std::string escape = R"(\u001b]0;owned\u0007\u009b31m)";
  const std::string formula = "=cmd|'/c calc'!A1";
  const std::string input = folder.write("names.json", R"json({"name": "names", "title": ")json" + escape +
                                                           R"json(", "geometry": {"polygon": [[0, 0], [1, 0],
        [1, 1], [0, 1]], "labels": [")json" + escape + R"json(", ")json" +
                                                           formula + R"json(", "a,\"b", "-1+1\r\n"]},
        "parameters": {"a": 1}, "x-note": ")json" + escape +
                                                           R"json(",
        "problem": {"exact": "x^2*y", "boundary": {"*": {"dirichlet": "exact"}}},
        "functionals": {")json" + escape + R"json(": {"integral": "*"}, ")json" +
                                                           formula +
                                                           R"json(": {"integral": "*"}},
        "targets": {"vertices": 100, "max_iterations": 2}, "initial": {"vertices": 100}, "mesher": {"preset": "fast"}})json");
  const ProgramResult result = run_program({"run", input, "-v", "--out", folder / "out\x1b[31m"});
  INFO(result.err);
  REQUIRE(result.exit_code == 0);
  CHECK_FALSE(has_control_characters(result.out));
  CHECK_FALSE(has_control_characters(result.err));
  CHECK_THAT(result.out, Catch::Contains("\\x1b]0;owned\\x07"));
  const std::string table = content_of(folder / "out\x1b[31m/convergence.csv");
  CHECK(table.find('=') == std::string::npos);  // it has numbers only; texts in tables: csv.test.cpp
  CHECK(table.find('\x1b') == std::string::npos);
  // Formats that have names for labels stay readable.
  fs::copy_file(input, folder / "geometry.json");
  for (const char* name : {"a.msh", "a.vtu"}) {
    INFO(name);
    CHECK(run_program({"convert", folder / "geometry.json", folder / name}).exit_code == 0);
  }
  for (const char* name : {"a.svg", "a.eps", "a.png"}) {
    INFO(name);
    CHECK(run_program({"convert", folder / "geometry.json", folder / name, "--labels"}).exit_code == 0);
  }
  CHECK(run_program({"quality", folder / "a.msh"}).exit_code == 0);
  CHECK_THAT(run_program({"convert", folder / "a.msh", folder / "b.msh"}).err, Catch::Equals(""));
}

TEST_CASE("bytes that are no text do not reach the terminal", "[system][hostile][errors]") {
  const ProgramResult result = run_program({"check",
                                            "no\x9b"
                                            "31m\xc3such\xff\xe2\x82"});
  CHECK_THAT(result.err, Catch::Contains("no\\x9b31m\\xc3such\\xff\\xe2\\x82"));
  CHECK_THAT(run_program({"check", "M\xc3\xbcller \xe2\x82\xac \xf0\x9f\xa7\x80"}).err,
             Catch::Contains("M\xc3\xbcller \xe2\x82\xac \xf0\x9f\xa7\x80"));
}

TEST_CASE("a case of hostile size is refused in time", "[system][hostile][errors]") {
  const TemporaryFolder folder;
  const auto refused = [&folder](const std::string& text) {
    const ProgramResult result =
        run_program({"check", folder.write("big.json", text), "--limit", "seconds=20", "--limit", "memory_mb=1500"});
    CHECK(result.exit_code == 3);
    CHECK(result.err.size() < 100000);
    return result.err;
  };
  std::string names, texts;
  for (int k = 0; k < 300000; ++k) names += (k > 0 ? ",\"k" : "\"k") + std::to_string(k) + "\":1";
  CHECK_THAT(refused("{" + names + "}"), Catch::Contains("more than 2000 names"));
  CHECK_THAT(refused("{\"x-a\":\n" + std::string(100000, '[') + std::string(100000, ']') + "}"),
             Catch::Contains(":2:64: nested more than 64 deep"));
  CHECK_THAT(refused("{\"name\": \"" + std::string(5000000, 'n') + "\"}"), Catch::Contains("/name"));
  std::string twice;
  for (int k = 0; k < 300000; ++k) twice += (k > 0 ? R"(,{"a":1,"a":1})" : R"({"a":1,"a":1})");
  CHECK_THAT(refused("{\"x-a\": [" + twice + "]}"), Catch::Contains("given twice"));
  std::string sum = "x";
  for (int k = 0; k < 100000; ++k) sum += "+sin(x*y)";
  CHECK_THAT(refused("{" + unit_square + R"(, "problem": {"interpolate": ")" + sum + "\"}}"),
             Catch::Contains("longer than 10000"));
  const std::string large = folder / "large.json";
  folder.write("large.json", "{");
  fs::resize_file(large, std::uintmax_t{1} << 31);  // a hole: takes no room on the disk
  const ProgramResult result = run_program({"check", large, "--limit", "memory_mb=500"});
  CHECK(result.exit_code == 3);
  CHECK_THAT(result.err, Catch::Contains("larger than 64 MiB"));
}
