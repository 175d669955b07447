#pragma once

#include <cstddef>
#include <cstdint>

#include "mesher/io/byte_writer.h"
#include "mesher/io/msh.h"
#include "mesher/io/output_file.h"

namespace parmesan {

/// Writes the numbers of a Gmsh file as text with blanks, or as bytes.
class MshNumbers {
 public:
  MshNumbers(OutputFile& out, Encoding encoding) : out_(out), bytes_(out), is_text_(encoding == Encoding::Text) {}

  void integer(int value) {
    if (is_text_) {
      out_ << value << ' ';
    } else {
      bytes_.write(std::int32_t{value});
    }
  }

  void size(std::size_t value) {
    if (is_text_) {
      out_ << value << ' ';
    } else {
      bytes_.write(static_cast<std::uint64_t>(value));
    }
  }

  void real(double value) {
    if (is_text_) {
      out_ << value << ' ';
    } else {
      bytes_.write_finite(value);
    }
  }

  /// Ends a row, which only text has.
  void end_row() {
    if (is_text_) out_ << '\n';
  }

  /// To be called after the last number of a section.
  void finish() {
    bytes_.flush();
    if (!is_text_) out_ << '\n';
  }

 private:
  OutputFile& out_;
  ByteWriter bytes_;
  bool is_text_;
};

}  // namespace parmesan
