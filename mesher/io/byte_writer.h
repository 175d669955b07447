#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <string_view>

#include "mesher/errors.h"
#include "mesher/io/output_file.h"

namespace parmesan {

/// Writes numbers as bytes in this machine's order, several at a time.
class ByteWriter {
 public:
  explicit ByteWriter(OutputFile& out) : out_(out) {}
  ByteWriter(const ByteWriter&) = delete;
  ByteWriter& operator=(const ByteWriter&) = delete;

  template <class Number>
  void write(Number number) {
    if (size_ + sizeof(Number) > buffer_.size()) flush();
    std::memcpy(buffer_.data() + size_, &number, sizeof(Number));
    size_ += sizeof(Number);
  }

  /// Errors: FileError for a number that is not finite.
  void write_finite(double number) {
    if (!std::isfinite(number)) throw FileError(out_.path(), 0, "was not written: a number is not finite");
    write(number);
  }

  /// To be called last, and before anything else is written to the file.
  void flush() {
    out_ << std::string_view(buffer_.data(), size_);
    size_ = 0;
  }

 private:
  OutputFile& out_;
  std::array<char, 4096> buffer_;
  std::size_t size_ = 0;
};

}  // namespace parmesan
