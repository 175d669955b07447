#include "mesher/io/medit_keywords.h"

#include <string_view>

namespace parmesan {
namespace {

std::string lower_case(std::string_view word) {
  std::string result(word);
  for (char& c : result) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return result;
}

}  // namespace

void read_medit_version(TextReader& in) {
  if (in.at_end() || lower_case(in.word("MeshVersionFormatted")) != "meshversionformatted") {
    in.fail("is no Medit file: it does not begin with MeshVersionFormatted");
  }
  const int version = in.integer("the format version");
  if (version < 0 || version > 4) in.fail("the format version is " + std::to_string(version) + ", known are 0 to 4");
}

std::string read_medit_keyword(TextReader& in) {
  std::string keyword = lower_case(in.word("the keyword End"));
  if (keyword.front() < 'a' || keyword.front() > 'z') in.fail("a keyword should stand here; is a count too small?");
  return keyword;
}

int read_medit_dimension(TextReader& in) {
  const int dimension = in.integer("the dimension");
  if (dimension != 2 && dimension != 3) in.fail("the dimension is " + std::to_string(dimension) + ", must be 2 or 3");
  return dimension;
}

}  // namespace parmesan
