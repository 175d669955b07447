#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "adapt/loop_state.h"

namespace parmesan {

/// Fowler-Noll-Vo hash FNV-1a of 64 bits: changes with any one byte. Not meant against forgery.
std::uint64_t checksum(std::string_view bytes);

/// The state of a loop, and what the case was (a checksum of it and of its files), as bytes with a checksum at
/// their end. Numbers as this machine has them in memory, so that reading gives the same bits.
std::string encode_checkpoint(const LoopState& state, std::uint64_t case_hash);

/// A checkpoint that was read.
struct Checkpoint {
  LoopState state;
  std::uint64_t case_hash = 0;
};

/// Errors: InputError for bytes that are not exactly what encode_checkpoint of this version gave.
Checkpoint decode_checkpoint(std::string_view bytes);

/// Writes the state into FOLDER/checkpoint, in place of the one before the last: two generations are kept, in
/// files that are complete or not there (power failures included). Errors: FileError.
void write_checkpoint(const std::string& folder, const LoopState& state, std::uint64_t case_hash);

/// The newest checkpoint in a run's folder that can be read, and what is wrong with newer ones. Cost: reads no older
/// one.
struct FoundCheckpoint {
  std::optional<Checkpoint> checkpoint;
  std::vector<std::string> problems;  // one sentence per file that cannot be used
};
FoundCheckpoint find_checkpoint(const std::string& folder);

}  // namespace parmesan
