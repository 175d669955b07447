#include "adapt/report/report.h"

#include <algorithm>
#include <array>
#include <bit>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <system_error>

#include "adapt/case_document.h"
#include "adapt/checkpoint.h"
#include "adapt/report/mesh_picture.h"
#include "adapt/report/page.h"
#include "mesher/errors.h"
#include "mesher/io/base64.h"
#include "mesher/io/output_file.h"
#include "mesher/io/picture/colour_map.h"
#include "mesher/io/text.h"

namespace parmesan {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr int most_triangles = 500'000;  // in one picture; the page has about 70 bytes for each
constexpr int num_colours = 64;
static_assert(std::endian::native == std::endian::little, "the page reads little-endian numbers");

/// A run or a comparison as the page is told of it.
struct Entry {
  Json about;                      // becomes one element of the page's data
  std::optional<Iterate> iterate;  // what is drawn
  MeshPicture picture;
};

std::string read_text(const std::string& path) {
  constexpr std::uint64_t most = std::uint64_t{4} * kMaxCaseBytes;  // with every default and indented
  std::error_code error;
  if (!fs::is_regular_file(path, error)) throw FileError(path, 0, "is not there: no finished run or comparison");
  return read_file(path, most);
}

// Deeper nesting would be the end of recursive code.
Json read_json(const std::string& path) {
  constexpr int most_levels = 64;
  bool is_too_deep = false;
  const auto watch = [&is_too_deep](int depth, Json::parse_event_t, Json&) {
    is_too_deep = is_too_deep || depth > most_levels;
    return !is_too_deep;
  };
  Json json = Json::parse(read_text(path), watch, false);
  if (json.is_discarded() || !json.is_object() || is_too_deep) throw FileError(path, 0, "is not what parmesan wrote");
  return json;
}

// The script of the page relies on these.
void check_shape(const std::string& folder, const Json& input, const Json& summary) {
  for (const char* section : {"geometry", "problem", "targets"})
    if (!input.contains(section) || !input[section].is_object())
      throw FileError(folder + "/case.json", 0, std::string("has no object '") + section + "'");
  const char* list = summary.contains("rows") ? "rows" : "iterations";
  const bool is_sound = summary.contains(list) && summary[list].is_array() &&
                        std::ranges::all_of(summary[list], [](const Json& row) { return row.is_object(); });
  if (!is_sound) throw FileError(folder + "/summary.json", 0, std::string("has no list of objects '") + list + "'");
}

// The exact solution, or the function that is interpolated, as the case has it.
std::optional<Expression> exact_of(const Json& input) {
  const Json& problem = input["problem"];
  for (const char* key : {"exact", "interpolate"}) {
    if (!problem.contains(key)) continue;
    if (problem[key].is_number()) return Expression::constant(problem[key].get<double>());
    if (!problem[key].is_string()) continue;
    const Json given = input.contains("parameters") ? input["parameters"] : Json::object();
    std::map<std::string, double> parameters;
    for (const auto& [name, value] : given.items())
      if (value.is_number()) parameters[name] = value.get<double>();
    return Expression::parse(problem[key].get<std::string>(), parameters);
  }
  return std::nullopt;
}

Json to_json(const Histogram& histogram) { return {{"bounds", histogram.bounds}, {"counts", histogram.counts}}; }

Entry entry_of(const std::string& folder) {
  Entry entry;
  const Json input = read_json(folder + "/case.json");
  const Json summary = read_json(folder + "/summary.json");
  check_shape(folder, input, summary);
  entry.about["folder"] = folder;
  entry.about["kind"] = summary.contains("rows") ? "compare" : "run";
  entry.about["case"] = input;
  entry.about["summary"] = summary;
  FoundCheckpoint found = find_checkpoint(folder);
  if (!found.checkpoint) return entry;
  entry.iterate = std::move(found.checkpoint->state.last);
  entry.picture = picture_of(*entry.iterate, exact_of(input));
  const Mesh& mesh = entry.iterate->mesh;
  const Point worst = worst_place(mesh, entry.picture.quality);
  entry.about["histograms"] = {{"lengths", to_json(entry.picture.lengths)},
                               {"angles", to_json(entry.picture.angles)},
                               {"qualities", to_json(entry.picture.qualities)}};
  entry.about["mesh"] = {{"drawn", mesh.num_triangles() <= most_triangles},
                         {"vertices", mesh.num_vertices()},
                         {"triangles", mesh.num_triangles()},
                         {"worst", {{"x", worst.x}, {"y", worst.y}, {"quality", entry.picture.quality.quality_min}}}};
  return entry;
}

// Text that stands in a script element must not end it, nor begin a comment.
std::string without_markup(const std::string& json) {
  std::string text;
  for (const char c : json) {
    if (c == '<' || c == '>' || c == '&') {
      constexpr char digits[] = "0123456789abcdef";
      text += std::string("\\u00") + digits[c / 16] + digits[c % 16];
    } else {
      text += c;
    }
  }
  return text;
}

void write_json(OutputFile& out, const Json& json) {
  out << R"(<script type="application/json" id="data">)"
      << without_markup(json.dump(-1, ' ', true, Json::error_handler_t::replace)) << "</script>\n";
}

template <class T>
void write_array(OutputFile& out, std::size_t entry, const char* name, std::span<const T> values) {
  out << R"(<script type="text/plain" id="array-)" << entry << "-" << name << R"(">)";
  Base64Writer base64(out);
  base64.write(values.data(), values.size_bytes());
  base64.finish();
  out << "</script>\n";
}

std::vector<float> single_precision(const std::vector<double>& values) { return {values.begin(), values.end()}; }

// In double precision what may have any size, or differ in the last digits only: points, values and errors.
void write_arrays(OutputFile& out, std::size_t number, const Entry& entry) {
  const Mesh& mesh = entry.iterate->mesh;
  write_array<Point>(out, number, "points", mesh.points);
  write_array<std::array<int, 3>>(out, number, "triangles", mesh.triangles);
  write_array<std::array<int, 2>>(out, number, "edges", mesh.edges);
  write_array<double>(out, number, "solution", entry.iterate->values);
  write_array<float>(out, number, "quality", single_precision(entry.picture.quality.qualities));
  if (!entry.picture.error.empty()) write_array<double>(out, number, "error", entry.picture.error);
}

void write_head(OutputFile& out) {
  out << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      << "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'sha256-"
      << report_page.style_hash << "'; script-src 'sha256-" << report_page.script_hash
      << "'; base-uri 'none'; form-action 'none'\">\n"
      << "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      << "<title>Parmesan report</title>\n<style>" << report_page.style << "</style>\n</head>\n<body>\n"
      << "<noscript>This page draws its plots and meshes by a script, which the browser does not run.</noscript>\n";
}

}  // namespace

std::vector<std::string> write_report(const std::string& path, const std::vector<std::string>& folders) {
  std::vector<Entry> entries;
  std::vector<std::string> missing;
  entries.reserve(folders.size());
  for (const std::string& folder : folders) {
    entries.push_back(entry_of(folder));
    if (!entries.back().iterate && entries.back().about["kind"] == "run")
      missing.push_back(folder +
                        ": there is no checkpoint that can be read, so the page lacks its mesh and histograms");
  }
  Json data;
  data["version"] = PARMESAN_VERSION;
  for (int k = 0; k < num_colours; ++k) data["colours"].push_back(colour_at(k / (num_colours - 1.0)));
  for (const Entry& entry : entries) data["entries"].push_back(entry.about);
  OutputFile out(path);
  write_head(out);
  write_json(out, data);
  for (std::size_t k = 0; k < entries.size(); ++k)
    if (entries[k].about.contains("mesh") && entries[k].about["mesh"]["drawn"]) write_arrays(out, k, entries[k]);
  out << "<script>" << report_page.script << "</script>\n</body>\n</html>\n";
  out.commit();
  return missing;
}

}  // namespace parmesan
