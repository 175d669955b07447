#include "mesher/io/byte_reader.h"

#include "mesher/errors.h"

namespace parmesan {

std::string_view ByteReader::line(const char* what) {
  last_ = position_;
  const std::size_t end = bytes_.find('\n', position_);
  if (end == std::string_view::npos) fail_at_end(what);
  std::string_view text = bytes_.substr(position_, end - position_);
  if (text.ends_with('\r')) text.remove_suffix(1);
  position_ = end + 1;
  return text;
}

std::size_t ByteReader::count(std::int64_t value, std::size_t bytes_each, const char* what) const {
  if (value < 0) fail(std::string(what) + " is negative");
  const auto n = static_cast<std::uint64_t>(value);
  if (n > (bytes_.size() - position_) / bytes_each) {
    fail(std::string(what) + " is larger than the file can hold; is it cut off?");
  }
  return static_cast<std::size_t>(n);
}

void ByteReader::fail(const std::string& problem) const {
  throw FileError(*name_, 0, "at byte " + std::to_string(last_) + ": " + problem);
}

void ByteReader::fail_value(const std::string& problem) const {
  throw FileValueError(*name_, 0, "at byte " + std::to_string(last_) + ": " + problem);
}

void ByteReader::fail_at_end(const char* what) const {
  fail(std::string("the file ends where ") + what + " should be; is it cut off?");
}

}  // namespace parmesan
