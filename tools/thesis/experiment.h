#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mesher/generate.h"
#include "mesher/quality.h"

namespace parmesan::thesis {

using Json = nlohmann::ordered_json;

/// Where pictures go, and whether all is done small.
struct Setting {
  std::string folder;
  bool quick = false;
};

/// Limits that one of our numbers must keep.
struct Law {
  std::optional<double> min = std::nullopt;
  std::optional<double> max = std::nullopt;
};

/// What one experiment of the thesis gave, there and here, as it goes into results.json.
class Item {
 public:
  Item(std::string name, std::string title);

  /// One number: what it is, the thesis's (null where it gives none), ours, and why they differ.
  void add(const std::string& what, const Json& of_thesis, double ours, const std::string& why = "", Law law = {});
  void add_table(const std::string& title, std::vector<std::string> columns,
                 const std::vector<std::vector<Json>>& rows);
  /// A picture in the folder, by its file name.
  void add_picture(const std::string& file, const std::string& caption);
  /// Columns of a table to be drawn over its first one; both axes logarithmic or not.
  void add_chart(const std::string& title, std::vector<std::string> columns,
                 const std::vector<std::vector<double>>& rows, bool logarithmic);
  void add_note(const std::string& text);
  const Json& json() const { return json_; }

 private:
  Json json_;
};

/// A mesh with what is said of it.
struct Run {
  Mesh mesh;
  MeshQuality quality;
  std::optional<ThesisReport> report;  // of the thesis's schedule
  double seconds = 0.0;                // CPU
  double elapsed = 0.0;                // seconds by the clock

  double vertices() const { return mesh.num_vertices(); }
  double triangles() const { return mesh.num_triangles(); }
  double picks_per_particle() const { return report ? static_cast<double>(report->picks) / vertices() : 0.0; }
};

/// Meshes and measures. Throws where the mesh is not valid (generate does).
Run run(const Domain& domain, const MetricField& field, const GenerateOptions& options,
        std::optional<Mesh> previous = std::nullopt);

/// How many threads meshing uses from here on; 0: one for each core. One at the start, for times are compared.
void use_threads(int count);

/// The thesis's schedule with these parameters.
GenerateOptions as_written(const ParticleOptions& thesis = {}, std::uint64_t seed = 1);

/// The side length of a uniform mesh with about n vertices on this area.
double size_for(double area, double vertices);

Domain rectangle(double width, double height);
Domain polygon(const std::vector<Point>& corners);

/// Writes a picture without axes into the folder.
void draw(const Setting& setting, const std::string& file, const Mesh& mesh);

/// Shares in equal bins; a value outside of the range counts into the last bin on its side.
std::vector<std::vector<double>> histogram(const std::vector<double>& values, double low, double high, int bins);

/// All angles of all triangles, in degrees, Euclidean.
std::vector<double> angles_of(const Mesh& mesh);

/// The slope of log y over log x by least squares.
double fitted_exponent(const std::vector<double>& x, const std::vector<double>& y);

Item table_2_1(const Setting& setting);
Item in_circle_forms(const Setting& setting);
Item evolution(const Setting& setting);
Item uniform_square(const Setting& setting);
Item potentials(const Setting& setting);
Item gaussian(const Setting& setting);
Item background_mesh(const Setting& setting);
Item forces(const Setting& setting);
Item running_time(const Setting& setting);
Item picking_order(const Setting& setting);
Item remeshing(const Setting& setting);
Item population(const Setting& setting);
Item oscillation(const Setting& setting);

}  // namespace parmesan::thesis
