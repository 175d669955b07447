#include "mesher/io/evolution.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <string_view>

#include "mesher/errors.h"
#include "mesher/io/evolution_page.h"
#include "mesher/io/output_file.h"
#include "mesher/io/picture/view.h"
#include "mesher/io/vtu.h"
#include "mesher/triangulation/conversion.h"

namespace parmesan {
namespace {

namespace fs = std::filesystem;

constexpr const char* list_name = "evolution.pvd";
constexpr const char* page_name = "index.html";
constexpr double step_growth = 1.12;
constexpr double grid = 9999.0;  // coordinates on the page are whole numbers up to this

std::string frame_name(std::size_t i) {
  std::string digits = std::to_string(i);
  return "frame_" + std::string(3 - std::min<std::size_t>(3, digits.size()), '0') + digits + ".vtu";
}

bool is_frame_name(const std::string& name) {
  const std::string_view head = "frame_", tail = ".vtu";
  return name.starts_with(head) && name.ends_with(tail) && name.size() > head.size() + tail.size() &&
         name.find_first_not_of("0123456789", head.size()) == name.size() - tail.size();
}

// So that what the user has put into a folder stays, and of an earlier evolution nothing.
void clear(const std::string& folder) {
  std::vector<fs::path> earlier;
  bool is_empty = true;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (is_frame_name(name) || name == page_name) earlier.push_back(entry.path());
    is_empty = false;
  }
  if (!is_empty && !fs::exists(folder + "/" + list_name))
    throw FileError(folder, 0, "the folder has files of something else than an evolution; name a new one");
  for (const fs::path& path : earlier) fs::remove(path);
}

template <class Numbers>
void append_list(std::string& text, const Numbers& numbers) {
  text += '[';
  for (const auto number : numbers) text += std::to_string(number) + ',';
  if (text.back() == ',') text.pop_back();
  text += ']';
}

// {s: step, w, h: extent, p: [x, y, ...], t: [a, b, c, ...], e: [a, b, ...]}
std::string page_frame(const Mesh& mesh, std::int64_t step) {
  const Bounds bounds = bounds_of(mesh);
  const Vector extent = bounds.high - bounds.low;
  const double scale = grid / std::max(extent.x, extent.y);
  std::vector<long> points;
  for (const Point& p : mesh.points) {
    points.push_back(std::lround((p.x - bounds.low.x) * scale));
    points.push_back(std::lround((p.y - bounds.low.y) * scale));
  }
  std::vector<int> triangles;
  for (const auto& t : mesh.triangles) triangles.insert(triangles.end(), t.begin(), t.end());
  std::vector<int> edges;
  for (const auto& e : mesh.edges) edges.insert(edges.end(), e.begin(), e.end());
  std::string text = "{s:" + std::to_string(step) + ",w:" + std::to_string(std::lround(extent.x * scale)) +
                     ",h:" + std::to_string(std::lround(extent.y * scale)) + ",p:";
  append_list(text, points);
  text += ",t:";
  append_list(text, triangles);
  text += ",e:";
  append_list(text, edges);
  return text + "}";
}

}  // namespace

EvolutionWriter::EvolutionWriter(std::string folder) : folder_(std::move(folder)) {
  try {
    fs::create_directories(folder_);
    clear(folder_);
  } catch (const fs::filesystem_error& error) {
    throw FileError(folder_, 0, "the folder cannot be made or cleared: " + error.code().message());
  }
  write_pvd(folder_ + "/" + list_name, {});
}

void EvolutionWriter::see(const ParticleSystem& particles, std::int64_t step) {
  last_step_ = step;
  if (step < next_step_) return;
  next_step_ = std::max(step + 1, static_cast<std::int64_t>(static_cast<double>(step) * step_growth));
  std::vector<int> labels(particles.domain().segments.size());
  std::iota(labels.begin(), labels.end(), 0);
  add(to_mesh(particles.mesh(), labels).mesh, step);
}

void EvolutionWriter::add(const Mesh& mesh, std::int64_t step) {
  write_vtu(folder_ + "/" + frame_name(steps_.size()), mesh);
  if (!frames_.empty()) frames_ += ",\n";
  frames_ += page_frame(mesh, step);
  steps_.push_back(step);
}

void EvolutionWriter::finish(const Mesh& last) {
  add(last, last_step_);
  std::vector<PvdEntry> entries;
  for (std::size_t i = 0; i < steps_.size(); ++i) entries.push_back({static_cast<double>(steps_[i]), frame_name(i)});
  write_pvd(folder_ + "/" + list_name, entries);
  OutputFile page(folder_ + "/" + page_name);
  page << evolution_page_head << frames_ << evolution_page_tail;
  page.commit();
}

}  // namespace parmesan
