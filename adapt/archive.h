#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "mesher/errors.h"

namespace parmesan {

/// Values one after another as bytes, as they are in memory: numbers, enumerations and plain structs of them,
/// and strings, vectors, maps and optionals of what an archive knows. A struct of those is described by
///
///     template <class Archive> void fields(Archive& archive, S& s) { archive(s.a, s.b); }
///
/// which serves for writing and for reading: the two cannot disagree. A writer changes nothing; fields that must do
/// more than pass members on ask Archive::is_reader.
template <class T>
constexpr bool is_plain = std::is_arithmetic_v<T> || std::is_enum_v<T>;

class ArchiveWriter {
 public:
  static constexpr bool is_reader = false;

  template <class... T>
  void operator()(const T&... values) {
    (write(values), ...);
  }

  const std::string& bytes() const { return bytes_; }

  /// The bytes without a copy; the archive is empty then.
  std::string take() { return std::exchange(bytes_, {}); }

 private:
  void append(const void* data, std::size_t size) { bytes_.append(static_cast<const char*>(data), size); }
  void write_count(std::size_t count) {
    const std::uint64_t n = count;
    append(&n, sizeof n);
  }

  template <class T>
  void write(const T& value) {
    if constexpr (is_plain<T>) {
      append(&value, sizeof value);
    } else {
      fields(*this, const_cast<T&>(value));  // the one fields for reader and writer
    }
  }
  void write(const std::string& text) {
    write_count(text.size());
    append(text.data(), text.size());
  }
  template <class T>
  void write(const std::vector<T>& values) {
    write_count(values.size());
    for (const T& value : values) write(value);
  }
  template <class T, std::size_t N>
  void write(const std::array<T, N>& values) {
    for (const T& value : values) write(value);
  }
  template <class K, class V>
  void write(const std::map<K, V>& values) {
    write_count(values.size());
    for (const auto& [key, value] : values) {
      write(key);
      write(value);
    }
  }
  template <class T>
  void write(const std::optional<T>& value) {
    write(value.has_value());
    if (value) write(*value);
  }

  std::string bytes_;
};

/// The inverse. Errors: InputError where the bytes end early; no count is believed beyond the bytes there are.
class ArchiveReader {
 public:
  static constexpr bool is_reader = true;

  explicit ArchiveReader(std::string_view bytes) : bytes_(bytes) {}

  template <class... T>
  void operator()(T&... values) {
    (read(values), ...);
  }

  bool at_end() const { return bytes_.empty(); }

 private:
  std::string_view take(std::size_t size) {
    if (size > bytes_.size()) throw InputError("ends too early");
    const std::string_view taken = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return taken;
  }
  std::size_t read_count() {
    std::uint64_t n = 0;
    std::memcpy(&n, take(sizeof n).data(), sizeof n);
    if (n > bytes_.size()) throw InputError("ends too early");  // every element takes a byte or more
    return static_cast<std::size_t>(n);
  }

  template <class T>
  void read(T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      value = take(1).front() != 0;
    } else if constexpr (is_plain<T>) {
      std::memcpy(&value, take(sizeof value).data(), sizeof value);
    } else {
      fields(*this, value);
    }
  }
  void read(std::string& text) { text = take(read_count()); }
  template <class T>
  void read(std::vector<T>& values) {
    values.clear();
    for (std::size_t n = read_count(); n > 0; --n) {
      values.emplace_back();
      read(values.back());
    }
  }
  template <class T, std::size_t N>
  void read(std::array<T, N>& values) {
    for (T& value : values) read(value);
  }
  template <class K, class V>
  void read(std::map<K, V>& values) {
    values.clear();
    for (std::size_t n = read_count(); n > 0; --n) {
      K key{};
      read(key);
      read(values[key]);
    }
  }
  template <class T>
  void read(std::optional<T>& value) {
    bool has = false;
    read(has);
    value.reset();
    if (has) read(value.emplace());
  }

  std::string_view bytes_;
};

}  // namespace parmesan
