#include "adapt/outputs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

#include "adapt/all_finite.h"
#include "adapt/convergence_csv.h"
#include "adapt/io/png.h"
#include "adapt/subfolder.h"
#include "mesher/errors.h"
#include "mesher/index.h"
#include "mesher/io/medit.h"
#include "mesher/io/medit_fields.h"
#include "mesher/io/msh.h"
#include "mesher/io/output_file.h"
#include "mesher/io/svg.h"
#include "mesher/io/vtu.h"

namespace parmesan {
namespace {

namespace fs = std::filesystem;

void make_folder(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) throw FileError(path, 0, "cannot make the folder: " + error.message());
}

// What a run or a comparison writes at its end, so that nothing of an earlier one is left to mislead.
constexpr std::array final_files{"summary.json", "report.html", "mesh.vtu", "mesh.mesh",   "mesh.sol",       "mesh.msh",
                                 "mesh.svg",     "mesh.png",    "run.pvd",  "compare.csv", "convergence.csv"};
constexpr std::array files_on_the_way{"case.json", "iterations", "checkpoint"};

void remove_files(const std::string& path, std::span<const char* const> names) {
  for (const char* name : names) {
    std::error_code error;
    fs::remove_all(fs::path(path) / name, error);
    if (error) throw FileError(path + "/" + name, 0, "cannot be removed: " + error.message());
  }
}

std::string three_digits(std::size_t number) {
  const std::string digits = std::to_string(number);
  return std::string(digits.size() < 3 ? 3 - digits.size() : 0, '0') + digits;
}

// |u_h - u| at the centroid of each triangle; 0 where u is not finite.
MeshField error_field(const Iterate& iterate, const ExactFunction& exact) {
  MeshField field{"error", 1, {}};
  for (const auto& t : iterate.mesh.triangles) {
    Point center;
    double value = 0.0;
    for (const int v : t) {
      center = center + (1.0 / 3.0) * iterate.mesh.points[at(v)];
      value += iterate.values[at(v)] / 3.0;
    }
    const double error = std::abs(value - exact.value(center));
    field.values.push_back(std::isfinite(error) ? error : 0.0);
  }
  return field;
}

MeshFields fields_of(const Case& input, const Iterate& iterate) {
  MeshFields fields;
  fields.points.push_back({"solution", 1, iterate.values});
  fields.points.push_back(tensor_field("metric", iterate.metrics));
  if (const auto known = known_function(input)) fields.cells.push_back(error_field(iterate, *known));
  return fields;
}

// mesh.mesh with the solution in mesh.sol, which cannot hold values that are not finite.
void write_solution(const std::string& folder, const Iterate& iterate) {
  write_medit(folder + "/mesh.mesh", iterate.mesh);
  if (all_finite(iterate.values))
    write_medit_fields(folder + "/mesh.sol", {.points = {{"solution", 1, iterate.values}}, .cells = {}});
}

// But for our lock.
bool is_empty(const std::string& path) {
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(path, error))
    if (entry.path().filename() != FolderLock::file_name) return false;
  if (error) throw FileError(path, 0, "cannot be read: " + error.message());
  return true;
}

PictureOptions picture_of(const Case& input, const Iterate& last) {
  PictureOptions options;
  options.title = input.title.empty() ? input.name : input.title;
  if (all_finite(last.values)) {
    options.values = last.values;
    options.values_name = "u";
  }
  return options;
}

}  // namespace

FolderLock prepare_folder(const std::string& path, EarlierFiles earlier) {
  std::error_code error;
  if (fs::exists(path, error) && !fs::is_directory(path, error))
    throw FileError(path, 0, "exists and is not a folder; choose another one with --out");
  make_folder(path);
  FolderLock lock(path);
  if (earlier == EarlierFiles::Refuse && !is_empty(path)) {
    throw FileError(
        path, 0,
        "the folder is not empty; --overwrite replaces what an earlier run left, --out chooses another folder, "
        "'run --resume' goes on with a run");
  }
  return lock;
}

void remove_earlier_files(const std::string& path, EarlierFiles earlier) {
  remove_files(path, final_files);
  if (earlier == EarlierFiles::Replace) remove_files(path, files_on_the_way);
}

RunFolder::RunFolder(const std::string& path, const Case& input, EarlierFiles earlier)
    : path_(path), lock_(prepare_folder(path, earlier)), case_(input), earlier_(earlier) {}

bool RunFolder::wants(const std::string& format) const {
  return std::ranges::find(case_.output.formats, format) != case_.output.formats.end();
}

void RunFolder::begin() {
  if (std::exchange(has_begun_, true)) return;
  remove_earlier_files(path_, earlier_);
  write_file(file("case.json"), case_.resolved.dump(2) + "\n");
}

void RunFolder::write_iteration(const Iterate& iterate, const IterationRow& row) {
  begin();
  const std::string folder =
      make_subfolder(path_, "iterations/" + three_digits(static_cast<std::size_t>(row.iteration)));
  if (wants("vtu")) write_vtu(folder + "/mesh.vtu", iterate.mesh, fields_of(case_, iterate));
  if (!wants("mesh")) return;
  write_solution(folder, iterate);
  write_medit_metric(folder + "/metric.sol", iterate.metrics);
}

void RunFolder::finish(const Summary& summary, const Iterate& last) {
  begin();
  if (wants("vtu")) {
    std::vector<PvdEntry> entries;
    for (std::size_t k = 0; k < summary.iterations.size(); ++k)
      entries.push_back({static_cast<double>(k), "iterations/" + three_digits(k) + "/mesh.vtu"});
    write_pvd(file("run.pvd"), entries);
    write_vtu(file("mesh.vtu"), last.mesh, fields_of(case_, last));
  }
  if (wants("mesh")) write_solution(path_, last);
  if (wants("msh")) write_msh(file("mesh.msh"), last.mesh, fields_of(case_, last));
  if (wants("svg")) write_svg(file("mesh.svg"), last.mesh, picture_of(case_, last));
  if (wants("png")) write_png(file("mesh.png"), last.mesh, picture_of(case_, last));
  write_file(file("convergence.csv"), convergence_csv(summary));
  write_file(file("summary.json"), to_json(summary).dump(2) + "\n", true);
}

}  // namespace parmesan
