#include "tests/support/corpus.h"

#include <cctype>
#include <charconv>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "mesher/io/geometry_file.h"
#include "tests/support/temporary_folder.h"

namespace parmesan::support {
namespace {

using Json = nlohmann::json;
using Ring = std::vector<Point>;

std::vector<std::vector<std::string>> rows_of(const std::string& path) {
  std::ifstream file(path);
  std::vector<std::vector<std::string>> rows;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    auto& cells = rows.emplace_back();
    std::istringstream columns(line);
    for (std::string cell; std::getline(columns, cell, ',');) cells.push_back(cell);
  }
  return rows;
}

/// All numbers of a text, whatever stands between them.
std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> numbers;
  const char* const end = text.data() + text.size();
  for (const char* at = text.data(); at != end;) {
    double value = 0.0;
    const bool starts = std::isdigit(static_cast<unsigned char>(*at)) != 0 || *at == '-' || *at == '.';
    const auto [next, error] = starts ? std::from_chars(at, end, value) : std::from_chars_result{at, std::errc{}};
    if (next != at && error == std::errc{}) numbers.push_back(value);
    at = next != at ? next : at + 1;
  }
  return numbers;
}

Ring ring_of(const std::vector<double>& numbers) {
  Ring ring;
  for (std::size_t i = 0; i + 1 < numbers.size(); i += 2) ring.push_back({numbers[i], numbers[i + 1]});
  return ring;
}

Domain closed(const std::vector<Ring>& rings) {
  Domain domain;
  for (Ring ring : rings) {
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    const int first = static_cast<int>(domain.points.size());
    const int n = static_cast<int>(ring.size());
    domain.points.insert(domain.points.end(), ring.begin(), ring.end());
    for (int i = 0; n > 1 && i < n; ++i) domain.segments.push_back({first + i, first + (i + 1) % n, 0});
  }
  return domain;
}

/// Lines of coordinates; a blank line or the word HOLE starts the next ring, STEINER ends them.
Domain from_lines(const std::string& text) {
  std::vector<Ring> rings;
  std::string ring;
  const auto finish = [&] {
    const Ring points = ring_of(numbers_in(ring));
    if (!points.empty()) rings.push_back(points);
    ring.clear();
  };
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("STEINER") != std::string::npos) break;
    if (line.find_first_not_of(" \t\r") == std::string::npos || line.find("HOLE") != std::string::npos) {
      finish();
    } else {
      ring += line + '\n';
    }
  }
  finish();
  return closed(rings);
}

/// Selig's format: a title, then the points around the airfoil.
Domain from_airfoil(const std::string& text) { return closed({ring_of(numbers_in(text.substr(text.find('\n') + 1)))}); }

Domain from_counted_lists(const std::string& text) {
  const std::vector<double> numbers = numbers_in(text);
  const auto num_points = static_cast<std::size_t>(numbers.at(0));
  const auto num_segments = static_cast<std::size_t>(numbers.at(1));
  Domain domain;
  std::size_t at = 2;
  for (std::size_t i = 0; i < num_points; ++i, at += 2) domain.points.push_back({numbers.at(at), numbers.at(at + 1)});
  for (std::size_t i = 0; i < num_segments; ++i, at += 2)
    domain.segments.push_back({static_cast<int>(numbers.at(at)), static_cast<int>(numbers.at(at + 1)), 0});
  return domain;
}

Domain from_wkt(const std::string& text) {
  std::vector<Ring> rings;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ')');) {
    const Ring ring = ring_of(numbers_in(part));
    if (!ring.empty()) rings.push_back(ring);
  }
  return closed(rings);
}

/// Every list of points, however deep.
void collect_rings(const Json& json, std::vector<Ring>& rings) {
  if (!json.is_array() || json.empty()) return;
  const bool is_ring = json.front().is_array() && !json.front().empty() && json.front().front().is_number();
  if (is_ring) {
    Ring& ring = rings.emplace_back();
    for (const Json& p : json) ring.push_back({p.at(0).get<double>(), p.at(1).get<double>()});
    return;
  }
  for (const Json& part : json) collect_rings(part, rings);
}

void collect_polygons(const Json& json, std::vector<Ring>& rings) {
  if (json.is_array()) {
    collect_rings(json, rings);
  } else if (json.contains("features")) {
    for (const Json& feature : json["features"]) collect_polygons(feature, rings);
  } else if (json.contains("geometries")) {
    for (const Json& geometry : json["geometries"]) collect_polygons(geometry, rings);
  } else if (json.contains("geometry")) {
    collect_polygons(json["geometry"], rings);
  } else {
    collect_rings(json.contains("rings") ? json["rings"] : json.at("coordinates"), rings);
  }
}

Domain from_json(const std::string& text) {
  const Json json = Json::parse(text);
  Domain domain;
  if (!json.is_object() || !json.contains("points")) {
    std::vector<Ring> rings;
    collect_polygons(json, rings);
    return closed(rings);
  }
  for (const Json& p : json["points"]) domain.points.push_back({p.at(0).get<double>(), p.at(1).get<double>()});
  for (const Json& s : json["segments"]) domain.segments.push_back({s.at(0).get<int>(), s.at(1).get<int>(), 0});
  return domain;
}

Domain read(const std::string& path) {
  const auto ends_with = [&path](const char* suffix) { return path.ends_with(suffix); };
  if (ends_with(".poly")) return read_geometry(path);
  const std::string text = content_of(path);
  if (ends_with("json")) return from_json(text);
  if (ends_with(".wkt")) return from_wkt(text);
  if (ends_with(".txt")) return from_counted_lists(text);
  return path.find("AeroSandbox") != std::string::npos ? from_airfoil(text) : from_lines(text);
}

}  // namespace

std::vector<CorpusEntry> corpus_entries(const std::string& corpus) {
  std::map<std::string, std::vector<std::string>> references;
  for (const auto& cells : rows_of(corpus + "/REFERENCE_CGAL.csv")) references[cells.at(0)] = cells;
  std::vector<CorpusEntry> entries;
  for (const auto& cells : rows_of(corpus + "/CLASSES.csv")) {
    CorpusEntry entry{cells.at(0), cells.at(1), std::stoi(cells.at(2)), std::stoi(cells.at(3)), std::stoi(cells.at(4))};
    const auto found = references.find(entry.file);
    if (found != references.end() && found->second.size() > 5 && !found->second[5].empty()) {
      entry.triangles = std::stoi(found->second[4]);
      entry.area = std::stod(found->second[5]);
    }
    entries.push_back(entry);
  }
  return entries;
}

Domain read_corpus_file(const std::string& path) {
  Domain domain = read(path);
  if (domain.points.empty()) throw std::runtime_error(path + " has no points");
  domain.inside = Inside::EvenOdd;
  domain.holes.clear();
  for (std::size_t s = 0; s < domain.segments.size(); ++s) domain.segments[s].label = static_cast<int>(s) + 1;
  return domain;
}

}  // namespace parmesan::support
