#include "mesher/io/medit_fields.h"

#include <filesystem>
#include <utility>

#include "mesher/errors.h"
#include "mesher/io/gmf.h"
#include "mesher/io/medit.h"
#include "mesher/io/medit_keywords.h"
#include "mesher/io/text.h"

namespace parmesan {
namespace {

/// The types of the fields of a section.
template <class In>
std::vector<int> read_types(In& in, int num_fields, int dimension) {
  constexpr int most_fields = 1000;
  if (num_fields < 1 || num_fields > most_fields) in.fail("the number of fields must be from 1 to 1000");
  std::vector<int> types(static_cast<std::size_t>(num_fields));
  for (int& type : types) {
    type = in.short_integer("the type of a field");
    if (type < 1 || type > 3) in.fail("the type of a field must be 1 (scalar), 2 (vector) or 3 (symmetric tensor)");
    if (type == 3 && dimension == 3) in.fail("a tensor field must have dimension 2");
  }
  return types;
}

/// One value: as many numbers as its type says, and a z that must be 0 of a vector in space.
template <class In>
void read_value(In& in, int type, int dimension, std::vector<double>& values) {
  for (int i = 0; i < type; ++i) values.push_back(in.real("a value"));
  if (type == 2 && dimension == 3 && in.real("the z component") != 0.0) in.fail("a vector leaves the plane");
}

/// The fields of a section of count entities, after its count. Memory is taken as values come: the counts may lie.
template <class In>
std::vector<MeshField> read_fields(In& in, int dimension, std::size_t count) {
  std::vector<MeshField> fields;
  for (const int type : read_types(in, in.short_integer("the number of fields"), dimension)) {
    fields.push_back({"", type, {}});
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (MeshField& field : fields) read_value(in, field.components, dimension, field.values);
  }
  return fields;
}

/// TextReader under the names that GmfReader has.
struct SolText : TextReader {
  using TextReader::TextReader;
  int short_integer(const char* what) { return integer(what); }
};

/// u.sol gives u, or u_1, u_2, ...
void name_fields(const std::string& path, std::vector<MeshField>& fields) {
  const std::string stem = std::filesystem::path(path).stem().string();
  for (std::size_t i = 0; i < fields.size(); ++i) {
    fields[i].name = fields.size() == 1 ? stem : stem + "_" + std::to_string(i + 1);
  }
}

MeshFields named(const std::string& path, MeshFields fields) {
  name_fields(path, fields.points);
  name_fields(path, fields.cells);
  return fields;
}

std::size_t num_entities(const std::vector<MeshField>& fields) {
  return fields.front().values.size() / static_cast<std::size_t>(fields.front().components);
}

/// write_number(value) for all numbers of an entity, end_row() after each.
template <class WriteNumber, class EndRow>
void write_rows(const std::vector<MeshField>& fields, const WriteNumber& write_number, const EndRow& end_row) {
  const std::size_t count = num_entities(fields);
  for (std::size_t i = 0; i < count; ++i) {
    for (const MeshField& field : fields) {
      const auto n = static_cast<std::size_t>(field.components);
      for (std::size_t k = 0; k < n; ++k) write_number(field.values[n * i + k]);
    }
    end_row();
  }
}

void write_sol_section(OutputFile& out, const char* keyword, const std::vector<MeshField>& fields) {
  if (fields.empty()) return;
  out << keyword << '\n' << num_entities(fields) << '\n' << fields.size();
  for (const MeshField& field : fields) out << ' ' << field.components;
  out << '\n';
  write_rows(
      fields, [&out](double value) { out << value << ' '; }, [&out] { out << '\n'; });
}

std::size_t bytes_each(const std::vector<MeshField>& fields) {
  std::size_t numbers = 0;
  for (const MeshField& field : fields) numbers += static_cast<std::size_t>(field.components);
  return numbers * sizeof(double);
}

std::size_t bytes_of(const std::vector<MeshField>& fields) {
  return fields.empty() ? 0 : num_entities(fields) * bytes_each(fields) + sizeof(std::int32_t) * fields.size();
}

void write_solb_section(GmfWriter& out, GmfKeyword keyword, const std::vector<MeshField>& fields) {
  if (fields.empty()) return;
  out.start(keyword, num_entities(fields), bytes_each(fields), sizeof(std::int32_t) * (1 + fields.size()));
  out.integer(static_cast<int>(fields.size()));
  for (const MeshField& field : fields) out.integer(field.components);
  write_rows(
      fields, [&out](double value) { out.real(value); }, [] {});
}

/// The one field at the vertices of a .solb file. Errors: FileError.
MeshField read_single_field(const std::string& path, int expected_count) {
  MeshFields fields = read_medit_fields(path);
  if (fields.points.size() != 1) throw FileError(path, 0, "must have one field at the vertices");
  const std::size_t count = num_entities(fields.points);
  if (count != static_cast<std::size_t>(expected_count)) {
    throw FileError(
        path, 0,
        "has " + std::to_string(count) + " values, the mesh has " + std::to_string(expected_count) + " vertices");
  }
  return std::move(fields.points.front());
}

std::vector<SymmetricTensor> tensors_of(const MeshField& field) {
  std::vector<SymmetricTensor> tensors;
  const std::vector<double>& v = field.values;
  for (std::size_t i = 0; i + 2 < v.size(); i += 3) tensors.push_back({v[i], v[i + 1], v[i + 2]});
  return tensors;
}

/// What make(value) returns for each of the values; what it refuses is refused with the number of the vertex.
template <class Value, class MakeMetric>
std::vector<Metric> make_metrics(const std::string& path, const std::vector<Value>& values, const MakeMetric& make) {
  std::vector<Metric> metrics;
  metrics.reserve(values.size());
  for (const Value& value : values) {
    try {
      metrics.push_back(make(value));
    } catch (const InputError& error) {
      throw FileError(path, 0, "vertex " + std::to_string(metrics.size() + 1) + ": " + error.what());
    }
  }
  return metrics;
}

}  // namespace

MeshFields parse_sol(std::string_view text, const std::string& name) {
  SolText in(text, name);
  read_medit_version(in);
  MeshFields result;
  int dimension = 2;
  for (std::string keyword = read_medit_keyword(in); keyword != "end"; keyword = read_medit_keyword(in)) {
    const bool at_vertices = keyword == "solatvertices";
    if (keyword == "dimension") {
      dimension = read_medit_dimension(in);
    } else if (at_vertices || keyword == "solattriangles") {
      std::vector<MeshField>& fields = at_vertices ? result.points : result.cells;
      if (!fields.empty()) in.fail("the same keyword a second time");
      const int count = in.count("the number of values", 1);
      fields = read_fields(in, dimension, static_cast<std::size_t>(count));
    } else {
      in.skip_to_keyword();
    }
  }
  if (result.empty()) in.fail("has neither SolAtVertices nor SolAtTriangles");
  return named(name, std::move(result));
}

MeshFields parse_solb(std::string_view bytes, const std::string& name) {
  GmfReader in(bytes, name);
  MeshFields result;
  const auto read_section = [&in](GmfKeyword keyword, std::vector<MeshField>& fields) {
    if (!in.has(keyword)) return;
    const std::size_t count = in.start(keyword, "the number of values", 1);
    fields = read_fields(in, in.dimension(), count);
    in.require_end();
  };
  read_section(GmfKeyword::SolAtVertices, result.points);
  read_section(GmfKeyword::SolAtTriangles, result.cells);
  if (result.empty()) in.fail("has neither SolAtVertices nor SolAtTriangles");
  return named(name, std::move(result));
}

MeshFields read_medit_fields(const std::string& path) {
  const std::string content = read_file(path);
  return file_suffix(path) == ".solb" ? parse_solb(content, path) : parse_sol(content, path);
}

void write_medit_fields(const std::string& path, const MeshFields& fields) {
  OutputFile out(path);
  if (file_suffix(path) == ".solb") {
    GmfWriter binary(out, bytes_of(fields.points) + bytes_of(fields.cells) + 200);
    write_solb_section(binary, GmfKeyword::SolAtVertices, fields.points);
    write_solb_section(binary, GmfKeyword::SolAtTriangles, fields.cells);
    binary.finish();
  } else {
    out << "MeshVersionFormatted 2\nDimension 2\n";
    write_sol_section(out, "SolAtVertices", fields.points);
    write_sol_section(out, "SolAtTriangles", fields.cells);
    out << "End\n";
  }
  out.commit();
}

std::vector<Metric> read_metric_file(const std::string& path, int expected_count) {
  if (file_suffix(path) != ".solb") return read_medit_metric(path, expected_count);
  const MeshField field = read_single_field(path, expected_count);
  if (field.components == 2) throw FileError(path, 0, "a metric must be of type 1 or 3");
  if (field.components == 1) return make_metrics(path, field.values, &Metric::isotropic);
  return make_metrics(path, tensors_of(field), &Metric::from_tensor);
}

std::vector<SymmetricTensor> read_tensor_file(const std::string& path, int expected_count) {
  if (file_suffix(path) != ".solb") return read_medit_tensor(path, expected_count);
  const MeshField field = read_single_field(path, expected_count);
  if (field.components != 3) throw FileError(path, 0, "the field must be of type 3, a symmetric tensor");
  return tensors_of(field);
}

}  // namespace parmesan
