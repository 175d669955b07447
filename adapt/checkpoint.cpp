#include "adapt/checkpoint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <limits>
#include <system_error>
#include <utility>

#include "adapt/all_finite.h"
#include "adapt/archive.h"
#include "adapt/checkpoint_fields.h"
#include "adapt/subfolder.h"
#include "mesher/errors.h"
#include "mesher/io/output_file.h"
#include "mesher/io/text.h"
#include "mesher/validate.h"

namespace parmesan {

namespace {

namespace fs = std::filesystem;

// Bytes in another order or another layout of the fields have another number here.
constexpr std::uint64_t format = 0x50'4d'53'4e'00'00'00'0c;
constexpr std::array names{"even.state", "odd.state"};  // rows of even and of odd number

/// What a checkpoint begins with.
struct Head {
  std::uint64_t format = 0;
  std::string version;
  int row = 0;  // the last one of the state
  std::uint64_t case_hash = 0;
};

template <class Archive>
void fields(Archive& archive, Head& h) {
  archive(h.format, h.version, h.row, h.case_hash);
}

bool is_ours(const Head& head) { return head.format == format && head.version == PARMESAN_VERSION; }

int row_of(const LoopState& state) {
  const std::vector<IterationRow>& rows = state.summary.iterations;
  return rows.empty() ? -1 : rows.back().iteration;
}

void check_mesh(const Mesh& mesh) {
  try {
    validate(mesh);
  } catch (const GeometryError& error) {
    throw InputError(std::string("has a mesh that cannot be used: ") + error.what());
  }
}

template <class Enumeration>
bool is_known(Enumeration value) {
  return !to_string(value).empty();
}

bool is_sound(const Diagnosis& diagnosis) {
  const auto sound = [](const Misfits& misfits) { return is_known(misfits.reason); };
  return std::ranges::all_of(diagnosis.long_edges, sound) && std::ranges::all_of(diagnosis.short_edges, sound) &&
         std::ranges::all_of(diagnosis.poor_triangles, sound);
}

bool is_sound(const Iterate& iterate) {
  const std::size_t n = iterate.mesh.points.size();
  return iterate.metrics.size() == n && iterate.values.size() == n && all_finite(iterate.values) &&
         (iterate.residual.empty() || iterate.residual.size() == n) && all_finite(iterate.residual) &&
         (iterate.dual.empty() || iterate.dual.size() == n) && all_finite(iterate.dual) &&
         std::isfinite(iterate.complexity) && is_known(iterate.report.start) && is_sound(iterate.report.diagnosis);
}

bool is_sound(const Summary& summary) {
  for (std::size_t k = 0; k < summary.iterations.size(); ++k) {
    const IterationRow& row = summary.iterations[k];
    if (row.iteration != static_cast<int>(k) || !is_known(row.start) || !is_sound(row.diagnosis)) return false;
  }
  return is_known(summary.stop_reason);
}

bool is_sound(const SizeStep& step) {
  return std::isfinite(step.asked) && step.asked > 0.0 && std::isfinite(step.vertices) && step.vertices > 0.0;
}

// A checksum finds damage, not forgery: the loop and the report must be able to compute on whatever passes.
void check(const LoopState& state) {
  check_mesh(state.last.mesh);
  if (state.last.relaxed) check_mesh(*state.last.relaxed);
  if (state.met) check_mesh(state.met->mesh);
  if (state.met && state.met->relaxed) check_mesh(*state.met->relaxed);
  const bool agrees = is_sound(state.last) && is_sound(state.summary) && std::isfinite(state.asked) &&
                      std::isfinite(state.seconds) && !state.history.empty() &&
                      state.history.size() == state.summary.iterations.size() &&
                      std::ranges::all_of(state.history, [](const SizeStep& step) { return is_sound(step); });
  if (!agrees) throw InputError("contradicts itself");
}

void require_regular(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(fs::symlink_status(path, error))) throw FileError(path, 0, "is not a regular file");
}

std::string read_bytes(const fs::path& path) {
  constexpr std::uint64_t most = std::uint64_t{1} << 36;  // some 10^9 vertices
  require_regular(path);
  return read_file(path, most);
}

/// The row that a file says it holds. What has no head of ours comes before all others, to be told of.
int row_in(const fs::path& path) {
  constexpr std::size_t enough = 256;  // bytes, for a head
  constexpr int before_all = std::numeric_limits<int>::max();
  try {
    require_regular(path);
    std::array<char, enough> start{};
    std::ifstream in(path, std::ios::binary);
    in.read(start.data(), std::ssize(start));
    Head head;
    ArchiveReader({start.data(), static_cast<std::size_t>(in.gcount())})(head);
    return is_ours(head) ? head.row : before_all;
  } catch (const InputError&) {
    return before_all;
  }
}

/// The files there are, that of the newest row first.
std::vector<fs::path> newest_first(const std::string& folder) {
  std::vector<std::pair<int, fs::path>> found;
  for (const char* name : names) {
    const fs::path path = fs::path(folder) / "checkpoint" / name;
    std::error_code error;
    if (fs::exists(fs::symlink_status(path, error))) found.emplace_back(row_in(path), path);
  }
  std::ranges::stable_sort(found, std::greater{}, &std::pair<int, fs::path>::first);
  std::vector<fs::path> paths;
  paths.reserve(found.size());
  for (auto& [row, path] : found) paths.push_back(std::move(path));
  return paths;
}

}  // namespace

std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

std::string encode_checkpoint(const LoopState& state, std::uint64_t case_hash) {
  ArchiveWriter archive;
  archive(Head{format, PARMESAN_VERSION, row_of(state), case_hash}, state);
  archive(checksum(archive.bytes()));
  return archive.take();
}

Checkpoint decode_checkpoint(std::string_view bytes) {
  constexpr std::size_t sum_bytes = sizeof(std::uint64_t);
  if (bytes.size() < sum_bytes) throw InputError("ends too early");
  const std::string_view content = bytes.substr(0, bytes.size() - sum_bytes);
  std::uint64_t sum = 0;
  ArchiveReader(bytes.substr(content.size()))(sum);
  if (sum != checksum(content)) throw InputError("is damaged: its checksum is wrong");
  ArchiveReader archive(content);
  Head head;
  archive(head);
  if (!is_ours(head)) throw InputError("was written by another version of parmesan");
  Checkpoint checkpoint;
  archive(checkpoint.state);
  if (!archive.at_end()) throw InputError("goes on after its end");
  check(checkpoint.state);
  checkpoint.case_hash = head.case_hash;
  return checkpoint;
}

void write_checkpoint(const std::string& folder, const LoopState& state, std::uint64_t case_hash) {
  const std::string path = make_subfolder(folder, "checkpoint");
  const auto which = static_cast<std::size_t>(row_of(state) % 2);
  write_file(path + "/" + names[which], encode_checkpoint(state, case_hash), true);
}

FoundCheckpoint find_checkpoint(const std::string& folder) {
  FoundCheckpoint found;
  for (const fs::path& path : newest_first(folder)) {
    try {
      found.checkpoint = decode_checkpoint(read_bytes(path));
      break;
    } catch (const FileError& problem) {
      found.problems.emplace_back(problem.what());
    } catch (const InputError& problem) {
      found.problems.push_back(path.string() + " " + problem.what());
    }
  }
  return found;
}

}  // namespace parmesan
