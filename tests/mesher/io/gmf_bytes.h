#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

namespace parmesan::support {

/// Builds a binary Medit file by hand, in any version and byte order.
class GmfBytes {
 public:
  GmfBytes(int version, bool swapped) : version_(version), swapped_(swapped) {
    append<std::int32_t>(1).append(version);
  }

  template <class Number>
  GmfBytes& append(Number number) {
    std::string raw(sizeof(Number), '\0');
    std::memcpy(raw.data(), &number, sizeof(Number));
    if (swapped_) std::reverse(raw.begin(), raw.end());
    bytes_ += raw;
    return *this;
  }

  GmfBytes& integer(int value) { return version_ < 4 ? append<std::int32_t>(value) : append<std::int64_t>(value); }
  GmfBytes& real(double value) { return version_ == 1 ? append(static_cast<float>(value)) : append(value); }

  /// A keyword; the place of the one behind it is filled in when that comes.
  GmfBytes& keyword(int code) {
    if (place_ > 0) {
      GmfBytes place(version_, swapped_);
      place.bytes_.clear();
      place.append_place(bytes_.size());
      bytes_.replace(place_, place.bytes_.size(), place.bytes_);
    }
    append<std::int32_t>(code);
    place_ = bytes_.size();
    append_place(0);
    return *this;
  }

  const std::string& bytes() const { return bytes_; }

 private:
  void append_place(std::size_t place) {
    if (version_ < 3) {
      append(static_cast<std::int32_t>(place));
    } else {
      append(static_cast<std::int64_t>(place));
    }
  }

  int version_;
  bool swapped_;
  std::string bytes_;
  std::size_t place_ = 0;  // of the place of the next keyword
};

/// Codes of keywords, from libMeshb's list.
namespace gmf {
inline constexpr int dimension = 3, vertices = 4, edges = 5, triangles = 6, quadrilaterals = 7, corners = 13, end = 54,
                     sol_at_vertices = 62, sol_at_triangles = 64;
}

/// One triangle with vertices (0, 0), (1, 0), (0, 1), two edges 1-2 (label 10) and 2-3 (label -4), and region 6.
inline std::string one_triangle(int version, bool swapped) {
  GmfBytes file(version, swapped);
  file.keyword(gmf::dimension).append<std::int32_t>(2);
  file.keyword(gmf::triangles).integer(1).integer(1).integer(2).integer(3).integer(6);
  file.keyword(gmf::corners).integer(1).integer(1);
  file.keyword(gmf::vertices).integer(3);
  for (const auto& [x, y] : {std::pair(0.0, 0.0), std::pair(1.0, 0.0), std::pair(0.0, 1.0)}) {
    file.real(x).real(y).integer(5);
  }
  file.keyword(gmf::edges).integer(2).integer(1).integer(2).integer(10).integer(2).integer(3).integer(-4);
  file.keyword(gmf::end);
  return file.bytes();
}

}  // namespace parmesan::support
