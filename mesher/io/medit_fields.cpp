#include "mesher/io/medit_fields.h"

#include <filesystem>
#include <utility>

#include "mesher/io/medit_sections.h"
#include "mesher/io/output_file.h"

namespace parmesan {
namespace {

/// The fields of a section of count entities, after its count. Memory is taken as values come: the counts may lie.
template <class In>
std::vector<MeshField> read_fields(In& in, int dimension, std::size_t count) {
  std::vector<MeshField> fields;
  for (const int type : read_field_types(in, dimension)) {
    fields.push_back({"", type, {}});
  }
  for (std::size_t i = 0; i < count; ++i) {
    for (MeshField& field : fields) read_field_value(in, field.components, dimension, field.values);
  }
  return fields;
}

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

template <class In>
MeshFields parse(In in, const std::string& name) {
  MeshFields result;
  read_sol_sections(in, [&](GmfKeyword keyword, int dimension, std::size_t count) {
    (keyword == GmfKeyword::SolAtVertices ? result.points : result.cells) = read_fields(in, dimension, count);
    return true;
  });
  if (result.empty()) in.fail("has neither SolAtVertices nor SolAtTriangles");
  return named(name, std::move(result));
}

}  // namespace

MeshFields parse_sol(std::string_view text, const std::string& name) { return parse(SolText(text, name), name); }

MeshFields parse_solb(std::string_view bytes, const std::string& name) { return parse(GmfReader(bytes, name), name); }

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

}  // namespace parmesan
