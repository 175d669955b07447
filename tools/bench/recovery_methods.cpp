// The methods of Hessian recovery side by side, on cases with a known solution.
//
//   recovery_methods [--vertices N] [CASE.json...]     N: size of the meshes (default 4000)
//
// Prints a markdown table. Errors: L2 norm of the Hessian's error at the vertices over that of the Hessian, inside and
// at the boundary, of the interpolant on a uniform mesh and on the mesh adapted with exact Hessians, and of the
// discrete solution there. Efficiencies: of the last mesh of the loop with this method, of the interpolant (whose nodal
// values are exact) and of the solution; every limit of the case's metric but h_min is taken away.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <exception>
#include <string>
#include <vector>

#include "adapt/absolute_hessian.h"
#include "adapt/adapt_loop.h"
#include "fem/vertex_patch.h"
#include "mesher/number_text.h"

namespace parmesan::bench {
namespace {

struct Method {
  const char* name;
  Recovery recovery;
};

constexpr std::array<Method, 4> methods{{{"least-squares", Recovery::LeastSquares},
                                         {"double-projection", Recovery::DoubleProjection},
                                         {"zienkiewicz-zhu", Recovery::ZienkiewiczZhu},
                                         {"polynomial-preserving", Recovery::PolynomialPreserving}}};

/// Relative L2 errors of recovered Hessians.
struct HessianError {
  double inner = 0.0;
  double boundary = 0.0;
};

double squared(const Hessian& h) { return h.xx * h.xx + 2.0 * h.xy * h.xy + h.yy * h.yy; }

HessianError hessian_error(const Case& input, const Iterate& iterate, Recovery recovery) {
  const std::vector<Hessian> recovered = recover_hessians(iterate.mesh, iterate.values, recovery);
  const std::vector<double> areas = vertex_areas(iterate.mesh);
  const VertexPatch patch(iterate.mesh);
  std::array<double, 2> error{}, scale{};  // boundary, inner
  for (std::size_t v = 0; v < recovered.size(); ++v) {
    const Jet u = input.exact->jet(iterate.mesh.points[v]);
    const Hessian& h = recovered[v];
    if (!std::isfinite(u.xx + u.xy + u.yy)) continue;
    const auto k = static_cast<std::size_t>(patch.is_inner(static_cast<int>(v)));
    error[k] += areas[v] * squared({h.xx - u.xx, h.xy - u.xy, h.yy - u.yy});
    scale[k] += areas[v] * squared({u.xx, u.xy, u.yy});
  }
  return {std::sqrt(error[1] / scale[1]), std::sqrt(error[0] / scale[0])};
}

/// The case with another metric and a size to aim at, solved or interpolated.
Case prepared(const std::string& file, const std::string& recovery, double vertices, bool interpolated) {
  const Case original = read_case(file);
  std::vector<Override> overrides{
      {"/metric",
       R"({"recovery": ")" + recovery + R"(", "max_aspect": 1e6, "h_min": )" + text(original.metric.h_min) + "}"},
      {"/targets", R"({"vertices": )" + std::to_string(static_cast<long>(vertices)) + R"(, "max_iterations": 40})"},
      {"/mesher", "{}"},
      {"/expect", "{}"}};
  if (interpolated) overrides.push_back({"/problem", R"({"interpolate": ")" + original.exact.value().text() + R"("})"});
  return read_case(file, overrides);
}

double last_efficiency(const Case& input) {
  return adapt(input, {}).summary.iterations.back().efficiency.value_or(std::nan(""));
}

void print_rows(const std::string& file, double vertices) {
  const Case interpolation = prepared(file, "exact", vertices, true);
  const Case equation = prepared(file, "exact", vertices, false);
  Iterate uniform = uniform_iterate(interpolation, vertices);
  compute_values(interpolation, uniform, nullptr);
  const LoopResult adapted = adapt(interpolation, {});
  Iterate solved = adapted.last;
  compute_values(equation, solved, nullptr);
  std::printf("| %s | exact | | | | | | | %.3f | %.3f |\n", equation.name.c_str(),
              adapted.summary.iterations.back().efficiency.value_or(std::nan("")), last_efficiency(equation));
  for (const Method& method : methods) {
    std::printf("| | %s ", method.name);
    for (const Iterate* iterate : std::vector<const Iterate*>{&uniform, &adapted.last, &solved}) {
      const HessianError e = hessian_error(interpolation, *iterate, method.recovery);
      std::printf("| %.3f | %.3f ", e.inner, e.boundary);
    }
    for (const bool interpolated : {true, false})
      std::printf("| %.3f ", last_efficiency(prepared(file, method.name, vertices, interpolated)));
    std::printf("|\n");
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace parmesan::bench

int main(int argc, char** argv) {
  double vertices = 4000.0;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], "--vertices") == 0 && i + 1 < argc)
      vertices = std::stod(argv[++i]);
    else
      files.emplace_back(argv[i]);
  }
  if (files.empty()) {
    for (const char* name : {"analytic", "wave_front", "wave_front_steep", "two_layers", "layer_poisson", "l_shape"})
      files.push_back(std::string(PARMESAN_SOURCE_DIR) + "/cases/" + name + ".json");
  }
  try {
    std::printf("| case | recovery | uniform | boundary | adapted | boundary | solution | boundary ");
    std::printf("| interpolant's loop | solution's loop |\n|---|---|---:|---:|---:|---:|---:|---:|---:|---:|\n");
    for (const std::string& file : files) parmesan::bench::print_rows(file, vertices);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
