#include "mesher/io/base64.h"

#include <algorithm>
#include <string_view>

namespace parmesan {

namespace {

constexpr char letters[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Three bytes are four letters of six bits, the highest first.
inline void encode(const unsigned char* group, char* text) {
  const unsigned bits = static_cast<unsigned>(group[0]) << 16U | static_cast<unsigned>(group[1]) << 8U | group[2];
  text[0] = letters[bits >> 18U];
  text[1] = letters[bits >> 12U & 63U];
  text[2] = letters[bits >> 6U & 63U];
  text[3] = letters[bits & 63U];
}

}  // namespace

void Base64Writer::write(const void* data, std::size_t size) {
  const auto* bytes = static_cast<const unsigned char*>(data);
  while (size_ < 3 && size > 0) {
    group_[size_++] = *bytes++;
    --size;
  }
  if (size_ == 3) {
    write_groups(group_.data(), 1);
    size_ = 0;
  }
  write_groups(bytes, size / 3);
  std::copy(bytes + size / 3 * 3, bytes + size, group_.begin() + static_cast<std::ptrdiff_t>(size_));
  size_ += size % 3;
}

void Base64Writer::write_groups(const unsigned char* bytes, std::size_t count) {
  constexpr std::size_t at_once = 1024;
  std::array<char, 4 * at_once> text;  // NOLINT: filled below
  while (count > 0) {
    const std::size_t n = std::min(count, at_once);
    for (std::size_t i = 0; i < n; ++i) encode(bytes + 3 * i, text.data() + 4 * i);
    out_ << std::string_view(text.data(), 4 * n);
    bytes += 3 * n;
    count -= n;
  }
}

void Base64Writer::finish() {
  if (size_ == 0) return;
  std::array<char, 4> text{};
  std::fill(group_.begin() + static_cast<std::ptrdiff_t>(size_), group_.end(), static_cast<unsigned char>(0));
  encode(group_.data(), text.data());
  std::fill(text.begin() + static_cast<std::ptrdiff_t>(size_) + 1, text.end(), '=');
  out_ << std::string_view(text.data(), text.size());
  size_ = 0;
}

}  // namespace parmesan
