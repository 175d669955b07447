#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace parmesan {

/// Reads numbers from the bytes of a binary file, and knows where in the file it stands.
///
/// Numbers have the byte order of this machine until swap_bytes() turns it.
/// Errors: every function throws FileError with the number of the byte, from 0. The bytes and the name must outlive
/// the reader.
class ByteReader {
 public:
  /// name: how messages call the file, usually its path.
  ByteReader(std::string_view bytes, const std::string& name, std::size_t position = 0)
      : bytes_(bytes), name_(&name), position_(position), last_(position) {}

  void swap_bytes() { is_swapped_ = true; }

  std::size_t position() const { return position_; }
  std::size_t size() const { return bytes_.size(); }

  /// Goes to a byte of the file, or to its end.
  void seek(std::size_t position) { position_ = std::min(position, bytes_.size()); }

  /// what: how messages call the number.
  template <class Number>
  Number read(const char* what) {
    last_ = position_;
    if (bytes_.size() - position_ < sizeof(Number)) fail_at_end(what);
    std::array<char, sizeof(Number)> raw;
    std::memcpy(raw.data(), bytes_.data() + position_, sizeof(Number));
    if (is_swapped_) std::reverse(raw.begin(), raw.end());
    position_ += sizeof(Number);
    return std::bit_cast<Number>(raw);
  }

  /// A finite number of either precision.
  template <class Number>
  double real(const char* what) {
    const Number value = read<Number>(what);
    if (!std::isfinite(value)) fail_value(std::string(what) + " is not finite");
    return static_cast<double>(value);
  }

  /// The rest of the line, without its end, after which the reader stands.
  std::string_view line(const char* what);

  /// Throws unless so many records of bytes_each bytes, at least 1, fit into the rest of the file.
  std::size_t count(std::int64_t value, std::size_t bytes_each, const char* what) const;

  /// Throws FileError at the last thing read.
  [[noreturn]] void fail(const std::string& problem) const;

  /// The same with FileValueError.
  [[noreturn]] void fail_value(const std::string& problem) const;

 private:
  [[noreturn]] void fail_at_end(const char* what) const;

  std::string_view bytes_;
  const std::string* name_;
  std::size_t position_;
  std::size_t last_;
  bool is_swapped_ = false;
};

}  // namespace parmesan
