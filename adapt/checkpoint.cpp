#include "adapt/checkpoint.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <system_error>
#include <utility>

#include "adapt/all_finite.h"
#include "adapt/archive.h"
#include "adapt/subfolder.h"
#include "mesher/errors.h"
#include "mesher/io/output_file.h"
#include "mesher/io/text.h"

namespace parmesan {

// What an archive needs to know of each struct; found by argument-dependent lookup. A field that is left out here
// is lost in a checkpoint: the test that resumes after each row sees to it.

template <class Archive>
void fields(Archive& archive, Point& p) {
  archive(p.x, p.y);
}

template <class Archive>
void fields(Archive& archive, Metric& m) {
  SymmetricTensor t = m.tensor();
  archive(t.xx, t.xy, t.yy);
  m = Metric::from_tensor(t);
}

template <class Archive>
void fields(Archive& archive, Mesh& m) {
  archive(m.points, m.triangles, m.regions, m.edges, m.labels, m.label_names, m.region_names, m.required.vertices,
          m.required.edges, m.required.triangles);
}

template <class Archive>
void fields(Archive& archive, Misfits& m) {
  archive(m.reason, m.count, m.place, m.worst);
}

template <class Archive>
void fields(Archive& archive, Diagnosis& d) {
  archive(d.num_triangles, d.long_edges, d.short_edges, d.poor_triangles);
}

template <class Archive>
void fields(Archive& archive, GenerateReport& r) {
  archive(r.start, r.start_reason, r.complexity, r.diagnosis, r.warnings);
}

template <class Archive>
void fields(Archive& archive, StageSeconds& s) {
  archive(s.mesh, s.solve, s.recover, s.measure, s.cpu);
}

template <class Archive>
void fields(Archive& archive, Clipped& c) {
  archive(c.count, c.low, c.high);
}

template <class Archive>
void fields(Archive& archive, ClippedSizes& c) {
  archive(c.h_min, c.h_max, c.aspect, c.gradation);
}

template <class Archive>
void fields(Archive& archive, SolutionBounds& b) {
  archive(b.lower, b.upper);
}

template <class Archive>
void fields(Archive& archive, SolveReport& r) {
  archive(r.solver, r.unknowns, r.iterations, r.backward_error, r.peclet_min, r.peclet_max, r.capturing_steps,
          r.capturing_change, r.correction_steps, r.correction_change, r.null_components, r.compatibility_mismatch,
          r.minimum, r.maximum, r.bounds);
}

template <class Archive>
void fields(Archive& archive, Iterate& i) {
  archive(i.mesh, i.relaxed, i.metrics, i.values, i.residual, i.dual, i.complexity, i.clipped, i.report, i.solve_report,
          i.fluxes, i.estimated_error, i.goal_error, i.seconds);
}

template <class Archive>
void fields(Archive& archive, SizeStep& s) {
  archive(s.asked, s.vertices, s.error, s.adapted);
}

template <class Archive>
void fields(Archive& archive, InterpolationLimit& l) {
  archive(l.value, l.relative_error, l.degenerate_share);
}

template <class Archive>
void fields(Archive& archive, ErrorNorms& e) {
  archive(e.l1, e.l2, e.linf, e.h1, e.num_nonfinite);
}

template <class Archive>
void fields(Archive& archive, EstimatedError& e) {
  archive(e.l2, e.h1, e.linf);
}

template <class Archive>
void fields(Archive& archive, WorstElement& w) {
  archive(w.center, w.quality);
}

template <class Archive>
void fields(Archive& archive, GoalError& e) {
  archive(e.error, e.magnitude);
}

template <class Archive>
void fields(Archive& archive, GoalRow& g) {
  archive(g.value, g.estimate, g.error);
}

template <class Archive>
void fields(Archive& archive, IterationRow& r) {
  archive(r.iteration, r.vertices, r.triangles, r.complexity, r.clipped, r.interpolation_error, r.efficiency,
          r.solution_error, r.estimated_error, r.residual_h1, r.goal, r.solve_report, r.fluxes, r.functionals,
          r.unit_edges, r.length_min, r.length_max, r.quality_min, r.quality_p01, r.quality_mean,
          r.quality_min_away_from_corners, r.worst, r.diagnosis, r.start, r.start_reason, r.seconds, r.peak_memory_mb);
}

template <class Archive>
void fields(Archive& archive, Summary& s) {
  archive(s.case_name, s.seed, s.threads, s.stop_reason, s.error_targets_declared, s.targets_met, s.interpolation_limit,
          s.warnings, s.iterations);
}

template <class Archive>
void fields(Archive& archive, LoopState& s) {
  archive(s.last, s.met, s.is_met, s.asked, s.unchanged, s.limits_bind, s.seconds, s.history, s.limit, s.summary);
}

namespace {

namespace fs = std::filesystem;

// Bytes in another order or another layout of the fields have another number here.
constexpr std::uint64_t format = 0x50'4d'53'4e'00'00'00'08;
constexpr std::array names{"even.state", "odd.state"};  // rows of even and of odd number

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

std::string read_bytes(const fs::path& path) {
  constexpr std::uint64_t most = std::uint64_t{1} << 36;  // some 10^9 vertices
  std::error_code error;
  if (!fs::is_regular_file(fs::symlink_status(path, error))) throw FileError(path, 0, "is not a regular file");
  return read_file(path, most);
}

int last_row(const Checkpoint& checkpoint) { return checkpoint.state.summary.iterations.back().iteration; }

}  // namespace

std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

std::string encode_checkpoint(const LoopState& state, std::uint64_t case_hash) {
  ArchiveWriter archive;
  std::uint64_t number = format;
  std::string version = PARMESAN_VERSION;
  LoopState copy = state;
  archive(number, version, case_hash, copy);
  std::uint64_t sum = checksum(archive.bytes());
  archive(sum);
  return archive.bytes();
}

Checkpoint decode_checkpoint(std::string_view bytes) {
  constexpr std::size_t sum_bytes = sizeof(std::uint64_t);
  if (bytes.size() < sum_bytes) throw InputError("ends too early");
  const std::string_view content = bytes.substr(0, bytes.size() - sum_bytes);
  std::uint64_t number = 0, sum = 0;
  std::string version;
  ArchiveReader(bytes.substr(content.size()))(sum);
  if (sum != checksum(content)) throw InputError("is damaged: its checksum is wrong");
  ArchiveReader archive(content);
  archive(number, version);
  if (number != format || version != PARMESAN_VERSION) throw InputError("was written by another version of parmesan");
  Checkpoint checkpoint;
  archive(checkpoint.case_hash, checkpoint.state);
  if (!archive.at_end()) throw InputError("goes on after its end");
  check(checkpoint.state);
  return checkpoint;
}

void write_checkpoint(const std::string& folder, const LoopState& state, std::uint64_t case_hash) {
  const std::string path = make_subfolder(folder, "checkpoint");
  const int row = state.summary.iterations.back().iteration;
  write_file(path + "/" + names[static_cast<std::size_t>(row % 2)], encode_checkpoint(state, case_hash), true);
}

FoundCheckpoint find_checkpoint(const std::string& folder) {
  FoundCheckpoint found;
  for (const char* name : names) {
    const fs::path path = fs::path(folder) / "checkpoint" / name;
    std::error_code error;
    if (!fs::exists(fs::symlink_status(path, error))) continue;
    try {
      Checkpoint candidate = decode_checkpoint(read_bytes(path));
      if (!found.checkpoint || last_row(candidate) > last_row(*found.checkpoint)) {
        found.checkpoint = std::move(candidate);
      }
    } catch (const FileError& problem) {
      found.problems.emplace_back(problem.what());
    } catch (const InputError& problem) {
      found.problems.push_back(path.string() + " " + problem.what());
    }
  }
  return found;
}

}  // namespace parmesan
