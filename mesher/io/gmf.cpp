#include "mesher/io/gmf.h"

#include <limits>

namespace parmesan {
namespace {

constexpr std::size_t largest_short_place = std::numeric_limits<std::int32_t>::max();

}  // namespace

GmfReader::GmfReader(std::string_view bytes, const std::string& name) : in_(bytes, name) {
  read_version();
  read_sections();
  if (!has(GmfKeyword::Dimension)) in_.fail("the keyword Dimension is missing");
  in_.seek(sections_[GmfKeyword::Dimension].begin);
  dimension_ = short_integer("the dimension");
  if (dimension_ != 2 && dimension_ != 3)
    in_.fail("the dimension is " + std::to_string(dimension_) + ", must be 2 or 3");
}

void GmfReader::read_version() {
  constexpr std::int32_t one_swapped = 0x01000000;
  const auto one = in_.read<std::int32_t>("the byte order");
  if (one != 1 && one != one_swapped) in_.fail("is no binary Medit file: it does not begin with the number 1");
  if (one == one_swapped) in_.swap_bytes();
  version_ = short_integer("the format version");
  if (version_ < 1 || version_ > 4) {
    in_.fail("the format version is " + std::to_string(version_) + ", known are 1 to 4");
  }
}

std::size_t GmfReader::read_place() {
  constexpr const char* what = "the place of the next keyword";
  const std::int64_t place = version_ < 3 ? in_.read<std::int32_t>(what) : in_.read<std::int64_t>(what);
  if (place <= static_cast<std::int64_t>(in_.position()) || place > static_cast<std::int64_t>(in_.size())) {
    in_.fail(std::string(what) + " is " + std::to_string(place) +
             ", which is not behind it in the file; is it cut off?");
  }
  return static_cast<std::size_t>(place);
}

void GmfReader::read_sections() {
  while (true) {
    const auto keyword = static_cast<GmfKeyword>(short_integer("the keyword End"));
    if (keyword == GmfKeyword::End) return;
    const std::size_t next = read_place();
    if (has(keyword)) in_.fail("the same keyword a second time");
    sections_[keyword] = {in_.position(), next};
    in_.seek(next);
  }
}

std::size_t GmfReader::start(GmfKeyword keyword, const char* what, std::size_t words_each) {
  const Section& section = sections_.at(keyword);
  in_.seek(section.begin);
  end_ = section.end;
  const std::int64_t count = version_ < 4 ? in_.read<std::int32_t>(what) : in_.read<std::int64_t>(what);
  if (count > std::numeric_limits<std::int32_t>::max()) in_.fail(std::string(what) + " does not fit into 32 bits");
  return in_.count(count, words_each * sizeof(std::int32_t), what);
}

void GmfReader::require_end() const {
  if (in_.position() != end_) in_.fail("the next keyword is not where this section ends; is a count wrong?");
}

int GmfReader::wide_integer(const char* what) {
  const auto value = in_.read<std::int64_t>(what);
  if (value != static_cast<std::int32_t>(value)) in_.fail(std::string(what) + " does not fit into 32 bits");
  return static_cast<int>(value);
}

void GmfReader::fail_index(const char* what, int value, int size) const {
  in_.fail_value(std::string(what) + " is " + std::to_string(value) + ", must be from 1 to " + std::to_string(size));
}

GmfWriter::GmfWriter(OutputFile& out, std::size_t bytes) : out_(out), is_long_(bytes > largest_short_place) {
  integer(1);
  integer(is_long_ ? 3 : 2);
  position_ = 2 * sizeof(std::int32_t);
  write_keyword(GmfKeyword::Dimension, position_ + 2 * sizeof(std::int32_t) + place_bytes());
  integer(2);
}

void GmfWriter::write_keyword(GmfKeyword keyword, std::size_t next) {
  integer(static_cast<int>(keyword));
  if (is_long_) {
    out_.write(static_cast<std::int64_t>(next));
  } else {
    out_.write(static_cast<std::int32_t>(next));
  }
  position_ = next;
}

void GmfWriter::start(GmfKeyword keyword, std::size_t count, std::size_t bytes_each, std::size_t head_bytes) {
  const std::size_t head = 2 * sizeof(std::int32_t) + place_bytes() + head_bytes;
  write_keyword(keyword, position_ + head + count * bytes_each);
  integer(static_cast<int>(count));
}

void GmfWriter::finish() {
  write_keyword(GmfKeyword::End, 0);
  out_.flush();
}

}  // namespace parmesan
