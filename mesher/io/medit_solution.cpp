#include "mesher/errors.h"
#include "mesher/io/medit.h"
#include "mesher/io/medit_keywords.h"
#include "mesher/io/output_file.h"
#include "mesher/io/text.h"

namespace parmesan {
namespace {

enum class FieldType { Scalar = 1, Vector = 2, Tensor = 3 };

/// The values of the one field of a solution file; read_values(in, type, count) takes them.
template <class ReadValues>
void read_solution(std::string_view text, const std::string& name, std::optional<int> expected_count,
                   const ReadValues& read_values) {
  TextReader in(text, name);
  read_medit_version(in);
  int dimension = 2;
  bool has_values = false;
  for (std::string keyword = read_medit_keyword(in); keyword != "end"; keyword = read_medit_keyword(in)) {
    if (keyword == "dimension") dimension = read_medit_dimension(in);
    if (keyword != "dimension" && keyword != "solatvertices") in.skip_to_keyword();
    if (keyword != "solatvertices") continue;
    if (has_values) in.fail("the same keyword a second time");
    const int count = in.count("the number of values", 1);
    if (expected_count && count != *expected_count) {
      in.fail("has " + std::to_string(count) + " values, the mesh has " + std::to_string(*expected_count) +
              " vertices");
    }
    if (in.integer("the number of fields") != 1) in.fail("the number of fields must be 1");
    const int type = in.integer("the type of the field");
    if (type == 3 && dimension == 3) in.fail("a tensor field must have dimension 2");
    read_values(in, static_cast<FieldType>(type), static_cast<std::size_t>(count));
    has_values = true;
  }
  if (!has_values) in.fail("the keyword SolAtVertices is missing");
}

/// What make() returns; what it refuses is refused with the line.
template <class MakeMetric>
Metric at_line(const TextReader& in, const MakeMetric& make) {
  try {
    return make();
  } catch (const InputError& error) {
    in.fail(error.what());
  }
}

Metric read_size(TextReader& in) {
  const double h = in.real("the size");
  return at_line(in, [h] { return Metric::isotropic(h); });
}

SymmetricTensor read_tensor(TextReader& in) {
  SymmetricTensor m;
  m.xx = in.real("m11");
  m.xy = in.real("m12");
  m.yy = in.real("m22");
  return m;
}

Metric read_metric(TextReader& in) {
  const SymmetricTensor m = read_tensor(in);
  return at_line(in, [&m] { return Metric::from_tensor(m); });
}

}  // namespace

std::vector<Metric> parse_medit_metric(std::string_view text, const std::string& name,
                                       std::optional<int> expected_count) {
  std::vector<Metric> metrics;
  read_solution(text, name, expected_count, [&metrics](TextReader& in, FieldType type, std::size_t count) {
    if (type != FieldType::Scalar && type != FieldType::Tensor) in.fail("a metric must be of type 1 or 3");
    metrics.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
      metrics.push_back(type == FieldType::Scalar ? read_size(in) : read_metric(in));
    }
  });
  return metrics;
}

std::vector<Metric> read_medit_metric(const std::string& path, std::optional<int> expected_count) {
  return parse_medit_metric(read_file(path), path, expected_count);
}

std::vector<SymmetricTensor> read_medit_tensor(const std::string& path, std::optional<int> expected_count) {
  std::vector<SymmetricTensor> tensors;
  read_solution(read_file(path), path, expected_count, [&tensors](TextReader& in, FieldType type, std::size_t count) {
    if (type != FieldType::Tensor) in.fail("the field must be of type 3, a symmetric tensor");
    tensors.reserve(count);
    for (std::size_t i = 0; i < count; ++i) tensors.push_back(read_tensor(in));
  });
  return tensors;
}

std::vector<double> read_medit_scalar(const std::string& path, std::optional<int> expected_count) {
  std::vector<double> values;
  read_solution(read_file(path), path, expected_count, [&values](TextReader& in, FieldType type, std::size_t count) {
    if (type != FieldType::Scalar) in.fail("the field must be of type 1, a scalar");
    values.reserve(count);
    for (std::size_t i = 0; i < count; ++i) values.push_back(in.real("the value"));
  });
  return values;
}

void write_medit_metric(const std::string& path, std::span<const Metric> metrics) {
  OutputFile out(path);
  out << "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n" << metrics.size() << "\n1 3\n";
  for (const Metric& metric : metrics) {
    const SymmetricTensor& m = metric.tensor();
    out << m.xx << ' ' << m.xy << ' ' << m.yy << '\n';
  }
  out << "End\n";
  out.commit();
}

void write_medit_scalar(const std::string& path, std::span<const double> values) {
  OutputFile out(path);
  out << "MeshVersionFormatted 2\nDimension 2\nSolAtVertices\n" << values.size() << "\n1 1\n";
  for (const double value : values) out << value << '\n';
  out << "End\n";
  out.commit();
}

}  // namespace parmesan
