#include "mesher/io/medit_fields.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "mesher/errors.h"
#include "mesher/io/medit.h"
#include "tests/mesher/io/error_line.h"
#include "tests/mesher/io/gmf_bytes.h"
#include "tests/support/temporary_folder.h"

using parmesan::FileError;
using parmesan::MeshField;
using parmesan::MeshFields;
using parmesan::Metric;
using parmesan::parse_sol;
using parmesan::parse_solb;
using parmesan::read_medit_fields;
using parmesan::write_medit_fields;
using parmesan::support::error_line;
using parmesan::support::error_message;
using parmesan::support::GmfBytes;
using parmesan::support::TemporaryFolder;

namespace gmf = parmesan::support::gmf;

namespace {

const std::string fields_head = "MeshVersionFormatted 2\nDimension 2\n";

/// Two vertices with a vector and a scalar, one triangle with a tensor.
MeshFields some_fields() {
  return {{{"u_1", 2, {1.0, -2.0, 0.1, 1e300}}, {"u_2", 1, {1.0 / 3.0, 5e-324}}}, {{"u", 3, {4.0, 0.5, 9.0}}}};
}

void check_same(const std::vector<MeshField>& a, const std::vector<MeshField>& b) {
  REQUIRE(a.size() == b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(a[i].name == b[i].name);
    CHECK(a[i].components == b[i].components);
    CHECK(a[i].values == b[i].values);
  }
}

}  // namespace

TEST_CASE("Several fields come back from a Medit solution bit by bit", "[mesher][io][medit]") {
  const TemporaryFolder folder;
  const std::string path = folder / GENERATE("u.sol", "u.solb", "u.SOLB");
  CAPTURE(path);
  write_medit_fields(path, some_fields());
  const MeshFields back = read_medit_fields(path);
  check_same(back.points, some_fields().points);
  check_same(back.cells, some_fields().cells);
}

TEST_CASE("Fields of a Medit solution in space are read where they lie in the plane", "[mesher][io][medit]") {
  const auto with_z = [](const std::string& z) {
    return "MeshVersionFormatted 1\nDimension 3\nSolAtVertices\n1\n2 1 2\n7 1 2 " + z + "\nEnd\n";
  };
  const MeshFields fields = parse_sol(with_z("0"), "v.sol");
  check_same(fields.points, {{"v_1", 1, {7.0}}, {"v_2", 2, {1.0, 2.0}}});
  CHECK(error_line([&] { parse_sol(with_z("3"), "v.sol"); }) == 6);
}

TEST_CASE("A binary solution of another machine is read", "[mesher][io][medit]") {
  const int version = GENERATE(1, 2, 3, 4);
  CAPTURE(version);
  GmfBytes file(version, true);
  file.keyword(gmf::dimension).append<std::int32_t>(2);
  file.keyword(gmf::sol_at_vertices).integer(2).append<std::int32_t>(2);
  file.append<std::int32_t>(1).append<std::int32_t>(3);
  for (const double x : {0.5, 1.0, 0.25, 2.0, 1.5, 3.0, 0.0, 4.0}) file.real(x);
  file.keyword(gmf::end);
  check_same(parse_solb(file.bytes(), "a/w.solb").points,
             {{"w_1", 1, {0.5, 1.5}}, {"w_2", 3, {1.0, 0.25, 2.0, 3.0, 0.0, 4.0}}});
}

TEST_CASE("Every fault in a solution of several fields is refused with its line", "[mesher][io][medit][errors]") {
  const auto line_of = [](const std::string& text) { return error_line([&text] { parse_sol(text, "t.sol"); }); };
  CHECK(line_of(fields_head + "End\n") == 3);
  CHECK(line_of(fields_head + "SolAtVertices\n1\n0\nEnd\n") == 5);
  CHECK(line_of(fields_head + "SolAtVertices\n1\n2000\nEnd\n") == 5);
  CHECK(line_of(fields_head + "SolAtVertices\n1\n2 1 4\n1 1 1 1 1\nEnd\n") == 5);
  CHECK(line_of(fields_head + "SolAtVertices\n1\n2 1 2\n1 1\nEnd\n") == 7);
  CHECK(line_of(fields_head + "SolAtVertices\n1\n1 1\ninf\nEnd\n") == 6);
  CHECK(line_of(fields_head + "SolAtVertices\n1\n1 1\n3\nSolAtVertices\n1\n1 1\n3\nEnd\n") == 7);
  CHECK(line_of(fields_head + "SolAtVertices\n1000000000\n1 1\n3\nEnd\n") == 4);
}

TEST_CASE("A binary solution that is cut off anywhere is refused", "[mesher][io][medit][errors]") {
  const TemporaryFolder folder;
  write_medit_fields(folder / "u.solb", some_fields());
  const std::string bytes = parmesan::support::content_of(folder / "u.solb");
  REQUIRE_NOTHROW(parse_solb(bytes, "u.solb"));
  for (std::size_t length = 0; length + 4 < bytes.size(); ++length) {
    CAPTURE(length);
    CHECK_THROWS_AS(parse_solb(bytes.substr(0, length), "u.solb"), FileError);
  }
}

TEST_CASE("A metric is the same from text and binary", "[mesher][io][medit]") {
  const TemporaryFolder folder;
  std::vector<Metric> metrics;
  for (int i = 0; i < 20; ++i) metrics.push_back(Metric::from_sizes(1.0 / (1 + 7 * i), 0.3 + i, 0.37 * i));
  const MeshFields fields{{parmesan::tensor_field("m", metrics)}, {}};
  for (const char* name : {"m.sol", "m.solb"}) {
    CAPTURE(name);
    write_medit_fields(folder / name, fields);
    const std::vector<Metric> back = parmesan::read_medit_metric(folder / name, 20);
    REQUIRE(back.size() == 20);
    for (std::size_t i = 0; i < 20; ++i) CHECK(back[i].tensor() == metrics[i].tensor());
    CHECK(parmesan::read_medit_tensor(folder / name, 20)[7] == metrics[7].tensor());
    CHECK_THROWS_AS(parmesan::read_medit_metric(folder / name, 19), FileError);
  }
}

TEST_CASE("Sizes are metrics, and what is no metric is refused alike in text and binary", "[mesher][io][medit]") {
  const TemporaryFolder folder;
  for (const char* name : {"h.sol", "h.solb"}) {
    CAPTURE(name);
    const std::string path = folder / name;
    const auto refusal = [&](const MeshFields& fields) {
      write_medit_fields(path, fields);
      return error_message([&] { parmesan::read_medit_metric(path, 2); });
    };
    CHECK(refusal({{{"h", 1, {0.25, 0.5}}}, {}}).empty());
    CHECK(parmesan::read_medit_metric(path, 2)[0].tensor() == parmesan::SymmetricTensor{16.0, 0.0, 16.0});
    CHECK_THAT(error_message([&] { parmesan::read_medit_tensor(path, 2); }), Catch::Contains("must be of type 3"));
    CHECK_THAT(refusal({{{"h", 1, {0.25, -0.5}}}, {}}), Catch::Contains("vertex 2"));
    CHECK_THAT(refusal({{{"v", 2, {1.0, 0.0, 1.0, 0.0}}}, {}}), Catch::Contains("must be of type 1 or 3"));
    CHECK_THAT(refusal({{{"a", 1, {1.0, 1.0}}, {"b", 1, {1.0, 1.0}}}, {}}),
               Catch::Contains("number of fields must be 1"));
    CHECK_THAT(refusal({{{"h", 1, {1.0}}}, {}}), Catch::Contains("has 1 values, the mesh has 2 vertices"));
    CHECK_THAT(refusal({{}, {{"h", 1, {1.0, 1.0}}}}), Catch::Contains("SolAtVertices is missing"));
  }
}

TEST_CASE("Values that are not finite are not written", "[mesher][io][medit][errors]") {
  const TemporaryFolder folder;
  const MeshFields fields{{{"u", 1, {1.0, std::numeric_limits<double>::quiet_NaN()}}}, {}};
  CHECK_THROWS_AS(write_medit_fields(folder / "u.sol", fields), FileError);
  CHECK_THROWS_AS(write_medit_fields(folder / "u.solb", fields), FileError);
  CHECK(folder.num_files() == 0);
}
