#pragma once

#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "mesher/io/gmf.h"
#include "mesher/io/medit_keywords.h"
#include "mesher/io/text.h"

namespace parmesan {

/// TextReader under the names that GmfReader has.
struct SolText : TextReader {
  using TextReader::TextReader;
  int short_integer(const char* what) { return integer(what); }
};

/// Goes through a Medit solution (.sol): where a section SolAtVertices or SolAtTriangles has its types and values,
/// read(keyword, dimension, count) takes them, or returns false. Errors: FileError, also for a section that comes
/// twice.
template <class Read>
void read_sol_sections(SolText& in, Read read) {
  read_medit_version(in);
  int dimension = 2;
  std::set<GmfKeyword> seen;
  for (std::string word = read_medit_keyword(in); word != "end"; word = read_medit_keyword(in)) {
    if (word == "dimension") {
      dimension = read_medit_dimension(in);
    } else if (word == "solatvertices" || word == "solattriangles") {
      const auto keyword = word == "solatvertices" ? GmfKeyword::SolAtVertices : GmfKeyword::SolAtTriangles;
      if (!seen.insert(keyword).second) in.fail("the same keyword a second time");
      const int count = in.count("the number of values", 1);
      if (!read(keyword, dimension, static_cast<std::size_t>(count))) in.skip_to_keyword();
    } else {
      in.skip_to_keyword();
    }
  }
}

/// The same of a binary one (.solb).
template <class Read>
void read_sol_sections(GmfReader& in, Read read) {
  for (const GmfKeyword keyword : {GmfKeyword::SolAtVertices, GmfKeyword::SolAtTriangles}) {
    if (!in.has(keyword)) continue;
    const std::size_t count = in.start(keyword, "the number of values", 1);
    if (read(keyword, in.dimension(), count)) in.require_end();
  }
}

/// How many fields a section has, and the type of each: 1 scalar, 2 vector, 3 symmetric tensor.
template <class In>
std::vector<int> read_field_types(In& in, int dimension) {
  constexpr int most_fields = 1000;
  const int num_fields = in.short_integer("the number of fields");
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
void read_field_value(In& in, int type, int dimension, std::vector<double>& values) {
  for (int i = 0; i < type; ++i) values.push_back(in.real("a value"));
  if (type == 2 && dimension == 3 && in.real("the z component") != 0.0) in.fail("a vector leaves the plane");
}

}  // namespace parmesan
