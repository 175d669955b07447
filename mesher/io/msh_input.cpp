#include "mesher/io/msh_input.h"

#include <charconv>
#include <system_error>

namespace parmesan {

MshInput::MshInput(std::string_view bytes, const std::string& name)
    : all_(bytes), text_(bytes, name), bytes_(bytes, name) {
  read_format();
}

void MshInput::read_format() {
  if (text_.at_end() || text_.word("$MeshFormat") != "$MeshFormat") {
    text_.fail(
        "is no Gmsh file: it does not begin with $MeshFormat (the .msh of FreeFEM and JIGSAW are other formats)");
  }
  const std::string version(text_.word("the format version"));
  is_version_2_ = version == "2" || version == "2.0" || version == "2.1" || version == "2.2";
  if (!is_version_2_ && version != "4.1")
    text_.fail("the format version must be 4.1 or 2.0 to 2.2; Gmsh's -format does it");
  const int type = text_.integer("the file type");
  if (type != 0 && type != 1) text_.fail("the file type must be 0 (text) or 1 (binary)");
  if (text_.integer("the size of numbers") != 8) text_.fail("the size of numbers must be 8");
  is_binary_ = type == 1;
  if (is_binary_) {
    constexpr std::int32_t one_swapped = 0x01000000;
    start_numbers();
    const auto one = bytes_.read<std::int32_t>("the byte order");
    if (one != 1 && one != one_swapped) bytes_.fail("the byte order must be told by the number 1");
    if (one == one_swapped) bytes_.swap_bytes();
    end_numbers();
  }
  if (text_.word("$EndMeshFormat") != "$EndMeshFormat") text_.fail("$EndMeshFormat should stand here");
}

void MshInput::skip_to_line(const std::string& word) {
  const std::size_t place = all_.find('\n' + word, text_.position());
  if (place == std::string_view::npos) fail("the section has no " + word + "; is the file cut off?");
  text_.seek(place);
}

void MshInput::start_numbers() {
  if (!is_binary_) return;
  text_.skip_line();
  bytes_.seek(text_.position());
  in_bytes_ = true;
}

void MshInput::end_numbers() {
  if (!is_binary_) return;
  text_.seek(bytes_.position());
  in_bytes_ = false;
}

std::int64_t MshInput::size(const char* what) {
  std::int64_t value = 0;
  if (is_binary_) {
    value = bytes_.read<std::int64_t>(what);
  } else {
    const std::string_view word = text_.word(what);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) fail(std::string(what) + " must be a whole number");
  }
  if (value < 0) fail(std::string(what) + " is negative");
  return value;
}

std::size_t MshInput::text_count(const char* what, std::size_t words_each) {
  return static_cast<std::size_t>(text_.count(what, static_cast<int>(words_each)));
}

std::size_t MshInput::fitting(std::int64_t value, const char* what, std::size_t words_each) {
  constexpr std::size_t least_bytes = 2;  // of a number: a blank before each digit; binary ones have 4
  const std::size_t position = is_binary_ ? bytes_.position() : text_.position();
  if (static_cast<std::uint64_t>(value) > (bytes_.size() - position) / (least_bytes * words_each) ||
      value > INT32_MAX) {
    fail(std::string(what) + " is larger than the file can hold; is it cut off?");
  }
  return static_cast<std::size_t>(value);
}

void MshInput::fail(const std::string& problem) const {
  if (is_binary_ && in_bytes_) bytes_.fail(problem);
  text_.fail(problem);
}

void MshInput::fail_value(const std::string& problem) const {
  if (is_binary_ && in_bytes_) bytes_.fail_value(problem);
  text_.fail_value(problem);
}

}  // namespace parmesan
