#include "mesher/io/base64.h"

#include <catch2/catch.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/temporary_folder.h"

using parmesan::support::content_of;
using parmesan::support::TemporaryFolder;

namespace {

/// The bytes in base64, written in pieces of the given size.
std::string encoded(const std::string& bytes, std::size_t piece) {
  const TemporaryFolder folder;
  parmesan::OutputFile out(folder / "f");
  parmesan::Base64Writer writer(out);
  for (std::size_t i = 0; i < bytes.size(); i += piece) {
    const std::string part = bytes.substr(i, piece);
    writer.write(part.data(), part.size());
  }
  writer.finish();
  out.commit();
  return content_of(folder / "f");
}

}  // namespace

TEST_CASE("Base64Writer agrees with the examples of RFC 4648, in pieces of any size", "[mesher][io]") {
  const std::vector<std::pair<std::string, std::string>> examples{{"", ""},
                                                                  {"f", "Zg=="},
                                                                  {"fo", "Zm8="},
                                                                  {"foo", "Zm9v"},
                                                                  {"foob", "Zm9vYg=="},
                                                                  {"fooba", "Zm9vYmE="},
                                                                  {"foobar", "Zm9vYmFy"},
                                                                  {"\xfb\xff\xfe", "+//+"}};
  for (const auto& example : examples) {
    for (std::size_t piece = 1; piece <= 7; ++piece) CHECK(encoded(example.first, piece) == example.second);
  }
}
