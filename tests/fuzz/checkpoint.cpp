#include <cstddef>
#include <cstdint>
#include <string>

#include "adapt/checkpoint.h"
#include "mesher/errors.h"
#include "tests/fuzz/check.h"

namespace {

constexpr std::uint64_t some_case = 42;

/// What stands before the state: the same in every checkpoint.
std::string header() {
  const std::string one = parmesan::encode_checkpoint({}, some_case);
  const std::string other = parmesan::encode_checkpoint({}, some_case + 1);
  std::size_t length = 0;
  while (one[length] == other[length]) ++length;
  return one.substr(0, length + sizeof some_case);
}

std::string with_checksum(std::string content) {
  const std::uint64_t sum = parmesan::checksum(content);
  return content.append(reinterpret_cast<const char*>(&sum), sizeof sum);
}

}  // namespace

/// Any bytes, between the header and the right checksum, are a state that is written and read again the same, or an
/// InputError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string start = header();
  const std::string state(reinterpret_cast<const char*>(data), size);
  try {
    const parmesan::Checkpoint checkpoint = parmesan::decode_checkpoint(with_checksum(start + state));
    const std::string bytes = parmesan::encode_checkpoint(checkpoint.state, checkpoint.case_hash);
    const parmesan::Checkpoint again = parmesan::decode_checkpoint(bytes);
    CHECK(parmesan::encode_checkpoint(again.state, again.case_hash) == bytes);
  } catch (const parmesan::InputError&) {
  }
  return 0;
}
