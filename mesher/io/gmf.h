#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "mesher/io/byte_reader.h"
#include "mesher/io/byte_writer.h"

namespace parmesan {

/// The keywords of Medit's binary files (GMF; L. Marechal, libMeshb, INRIA) that are understood here.
enum class GmfKeyword : std::int32_t {
  Dimension = 3,
  Vertices = 4,
  Edges = 5,
  Triangles = 6,
  Quadrilaterals = 7,
  Tetrahedra = 8,
  Prisms = 9,
  Hexahedra = 10,
  RequiredVertices = 15,
  RequiredEdges = 16,
  RequiredTriangles = 17,
  Pyramids = 49,
  End = 54,
  SolAtVertices = 62,
  SolAtTriangles = 64
};

/// Reads a binary Medit file of version 1 to 4 in either byte order.
///
///     1, version; then per section: keyword, place of the next one, number of entities, entities; last End
///
/// Version 1 has numbers of 32 bits, 2 reals of 64, 3 also places, 4 also integers.
/// Errors: every function throws FileError with the byte.
class GmfReader {
 public:
  /// Reads the places of all sections; a file without End counts as cut off.
  GmfReader(std::string_view bytes, const std::string& name);

  bool has(GmfKeyword keyword) const { return sections_.contains(keyword); }

  /// The dimension, 2 or 3.
  int dimension() const { return dimension_; }

  /// Goes to a section that is there and reads its number of entities of words_each numbers.
  std::size_t start(GmfKeyword keyword, const char* what, std::size_t words_each);

  /// Throws unless the section that was started ends here.
  void require_end() const;

  double real(const char* what) { return version_ == 1 ? in_.real<float>(what) : in_.real<double>(what); }

  /// An integer of the file's width, which must fit into 32 bits.
  int integer(const char* what) { return version_ < 4 ? in_.read<std::int32_t>(what) : wide_integer(what); }

  /// An integer of 32 bits in every version.
  int short_integer(const char* what) { return in_.read<std::int32_t>(what); }

  /// An index from 1 to size, as 0 to size - 1.
  int index(const char* what, int size) {
    const int value = integer(what);
    if (value < 1 || value > size) fail_index(what, value, size);
    return value - 1;
  }

  [[noreturn]] void fail(const std::string& problem) const { in_.fail(problem); }
  [[noreturn]] void fail_value(const std::string& problem) const { in_.fail_value(problem); }

 private:
  struct Section {
    std::size_t begin = 0;
    std::size_t end = 0;
  };

  void read_version();
  void read_sections();
  std::size_t read_place();
  int wide_integer(const char* what);
  [[noreturn]] void fail_index(const char* what, int value, int size) const;

  ByteReader in_;
  int version_ = 0;
  int dimension_ = 0;
  std::map<GmfKeyword, Section> sections_;
  std::size_t end_ = 0;  // of the section that was started
};

/// Writes a binary Medit file of version 2, or 3 when places do not fit into 32 bits.
class GmfWriter {
 public:
  /// Writes the head of a file in dimension 2. bytes: about how large the file will be.
  GmfWriter(OutputFile& out, std::size_t bytes);

  /// Begins a section of count entities; head_bytes and bytes_each: what follows the count, before the entities and of
  /// each of them.
  void start(GmfKeyword keyword, std::size_t count, std::size_t bytes_each, std::size_t head_bytes = 0);

  void real(double value) { out_.write_finite(value); }
  void integer(int value) { out_.write(std::int32_t{value}); }

  /// Writes End.
  void finish();

 private:
  void write_keyword(GmfKeyword keyword, std::size_t next);
  std::size_t place_bytes() const { return is_long_ ? sizeof(std::int64_t) : sizeof(std::int32_t); }

  ByteWriter out_;
  bool is_long_;
  std::size_t position_ = 0;  // where the next section begins
};

}  // namespace parmesan
