#include <algorithm>

#include "mesher/errors.h"
#include "mesher/io/medit.h"
#include "mesher/io/medit_sections.h"
#include "mesher/io/output_file.h"

namespace parmesan {
namespace {

constexpr int scalar = 1;
constexpr int tensor = 3;

/// What the values at the vertices have to be, and how messages say so.
struct Wanted {
  std::vector<int> types;
  const char* rule;
  std::optional<int> count;
};

/// make(type, numbers) of each value of the one field at the vertices. Memory is taken as values come where the file
/// alone says how many: it may lie. Errors: FileError; FileValueError where the value stands for what make refuses.
template <class Value, class In, class Make>
std::vector<Value> read_at_vertices(In& in, const Wanted& wanted, Make make) {
  std::vector<Value> values;
  bool is_there = false;
  read_sol_sections(in, [&](GmfKeyword keyword, int dimension, std::size_t count) {
    if (keyword != GmfKeyword::SolAtVertices) return false;
    is_there = true;
    if (wanted.count && count != static_cast<std::size_t>(*wanted.count))
      in.fail("has " + std::to_string(count) + " values, the mesh has " + std::to_string(*wanted.count) + " vertices");
    const std::vector<int> types = read_field_types(in, dimension);
    if (types.size() != 1) in.fail("the number of fields must be 1");
    if (std::ranges::find(wanted.types, types.front()) == wanted.types.end()) in.fail(wanted.rule);
    if (wanted.count) values.reserve(count);
    std::vector<double> numbers;
    for (std::size_t i = 0; i < count; ++i) {
      numbers.clear();
      read_field_value(in, types.front(), dimension, numbers);
      try {
        values.push_back(make(types.front(), numbers));
      } catch (const InputError& error) {
        in.fail_value("vertex " + std::to_string(i + 1) + ": " + error.what());
      }
    }
    return true;
  });
  if (!is_there) in.fail("the keyword SolAtVertices is missing");
  return values;
}

SymmetricTensor tensor_of(const std::vector<double>& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

template <class In>
std::vector<Metric> metrics_in(In& in, std::optional<int> expected_count) {
  return read_at_vertices<Metric>(in, {{scalar, tensor}, "a metric must be of type 1 or 3", expected_count},
                                  [](int type, const std::vector<double>& numbers) {
                                    return type == scalar ? Metric::isotropic(numbers[0])
                                                          : Metric::from_tensor(tensor_of(numbers));
                                  });
}

/// read(in) of a .sol or .solb file.
template <class Read>
auto read_either(const std::string& path, Read read) {
  const std::string content = read_file(path);
  if (file_suffix(path) == ".solb") {
    GmfReader in(content, path);
    return read(in);
  }
  SolText in(content, path);
  return read(in);
}

}  // namespace

std::vector<Metric> parse_medit_metric(std::string_view text, const std::string& name,
                                       std::optional<int> expected_count) {
  SolText in(text, name);
  return metrics_in(in, expected_count);
}

std::vector<Metric> read_medit_metric(const std::string& path, std::optional<int> expected_count) {
  return read_either(path, [&](auto& in) { return metrics_in(in, expected_count); });
}

std::vector<SymmetricTensor> read_medit_tensor(const std::string& path, std::optional<int> expected_count) {
  const Wanted wanted{{tensor}, "the field must be of type 3, a symmetric tensor", expected_count};
  return read_either(path, [&](auto& in) {
    return read_at_vertices<SymmetricTensor>(
        in, wanted, [](int, const std::vector<double>& numbers) { return tensor_of(numbers); });
  });
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

}  // namespace parmesan
