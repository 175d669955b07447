#include "fem/assembly.h"

#include <algorithm>
#include <array>

#include "fem/adjacency.h"
#include "fem/coefficients.h"
#include "fem/discontinuity_capturing.h"
#include "fem/load.h"
#include "fem/p1.h"
#include "fem/point_sources.h"
#include "fem/stabilization.h"
#include "mesher/parallel.h"

namespace parmesan {

namespace {

using Matrix3 = std::array<std::array<double, 3>, 3>;

/// Zero matrix with an entry for each pair of vertices that share a triangle.
RowMatrix zero_matrix(const Mesh& mesh) {
  const Adjacency neighbours = vertex_neighbours(mesh);
  RowMatrix matrix(mesh.num_vertices(), mesh.num_vertices());
  matrix.reserve(static_cast<Eigen::Index>(neighbours.items.size() + mesh.points.size()));
  for (int v = 0; v < mesh.num_vertices(); ++v) {
    matrix.startVec(v);
    bool before = true;
    for (const int w : neighbours.of(v)) {
      if (before && w > v) {
        matrix.insertBack(v, v) = 0.0;
        before = false;
      }
      matrix.insertBack(v, w) = 0.0;
    }
    if (before) matrix.insertBack(v, v) = 0.0;
  }
  matrix.finalize();
  return matrix;
}

/// What one triangle adds to the equations of its vertices.
struct ElementSystem {
  Matrix3 matrix{};
  SourceMoments load{};
  double area = 0.0;
  double peclet = 0.0;    // mesh Peclet number
  bool reacts = false;    // the reaction is not zero
  bool negative = false;  // the reaction is negative
};

/// Coefficients of one element, integrated against its basis functions.
struct ElementIntegrals {
  Diffusion diffusion{0.0, 0.0, 0.0};  // mean
  Vector velocity;                     // mean
  Matrix3 lower_order{};               // int (b.grad phi_j + c phi_j) phi_i
  bool reacts = false;                 // the reaction is not zero
  bool negative = false;               // the reaction is negative
};

ElementIntegrals integrate(const Problem& problem, const P1Element& element, int region) {
  ElementIntegrals result;
  for (const auto& [lambda, weight] : degree4_rule()) {
    const Point x = element.at(lambda);
    const Diffusion k = diffusion_at(problem, x, region);
    const Vector b = velocity_at(problem, x, region);
    const double c = reaction_at(problem, x, region);
    result.diffusion.xx += weight * k.xx;
    result.diffusion.xy += weight * k.xy;
    result.diffusion.yy += weight * k.yy;
    result.velocity = result.velocity + weight * b;
    result.reacts = result.reacts || c != 0.0;
    result.negative = result.negative || c < 0.0;
    if (!problem.velocity && c == 0.0) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        result.lower_order[i][j] += element.area * weight * lambda[i] * (dot(b, element.gradient[j]) + c * lambda[j]);
      }
    }
  }
  return result;
}

/// int K grad phi_j . grad phi_i, with rows that sum to zero.
Matrix3 stiffness(const P1Element& element, const Diffusion& k) {
  Matrix3 a{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    a[i][j] = a[j][i] = element.area * dot(element.gradient[i], k * element.gradient[j]);
  }
  for (std::size_t i = 0; i < 3; ++i) a[i][i] = -(a[i][(i + 1) % 3] + a[i][(i + 2) % 3]);
  return a;
}

/// Adds tau b_T.grad phi_i times the sum of the rows: the basis functions sum to 1, so that sum
/// tests the equation with 1 on the element.
void add_supg(const P1Element& element, const Vector& b, double tau, Matrix3& lower_order, SourceMoments& load) {
  std::array<double, 3> column{};
  for (std::size_t j = 0; j < 3; ++j) column[j] = lower_order[0][j] + lower_order[1][j] + lower_order[2][j];
  const double source = load[0] + load[1] + load[2];
  for (std::size_t i = 0; i < 3; ++i) {
    const double weight = tau * dot(b, element.gradient[i]);
    load[i] += weight * source;
    for (std::size_t j = 0; j < 3; ++j) lower_order[i][j] += weight * column[j];
  }
}

ElementSystem element_system(const Mesh& mesh, const Problem& problem, std::size_t t, const SourceMoments& load,
                             double crosswind) {
  const P1Element element = p1_element(mesh, static_cast<int>(t));
  ElementIntegrals integrals = integrate(problem, element, mesh.regions[t]);
  ElementSystem result{.load = load, .area = element.area, .reacts = integrals.reacts, .negative = integrals.negative};
  if (problem.velocity) {
    result.peclet = mesh_peclet(element, integrals.velocity, integrals.diffusion);
    const double tau = supg_parameter(element, integrals.velocity, integrals.diffusion);
    if (problem.stabilize && tau > 0.0) add_supg(element, integrals.velocity, tau, integrals.lower_order, result.load);
  }
  result.matrix = stiffness(element, integrals.diffusion + crosswind_tensor(crosswind, integrals.velocity));
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) result.matrix[i][j] += integrals.lower_order[i][j];
  }
  return result;
}

/// The equation of one vertex: the sum over its triangles in increasing order.
void gather(const Mesh& mesh, const Adjacency& stars, const std::vector<ElementSystem>& elements, int vertex,
            AssembledSystem& system) {
  const auto v = static_cast<std::size_t>(vertex);
  const int* const first = system.matrix.innerIndexPtr() + system.matrix.outerIndexPtr()[v];
  const int* const last = system.matrix.innerIndexPtr() + system.matrix.outerIndexPtr()[v + 1];
  double* const values = system.matrix.valuePtr() + system.matrix.outerIndexPtr()[v];
  for (const int triangle : stars.of(vertex)) {
    const auto t = static_cast<std::size_t>(triangle);
    const std::array<int, 3>& corners = mesh.triangles[t];
    const ElementSystem& element = elements[t];
    const auto i = static_cast<std::size_t>(std::ranges::find(corners, vertex) - corners.begin());
    for (std::size_t j = 0; j < 3; ++j) values[std::find(first, last, corners[j]) - first] += element.matrix[i][j];
    system.load[vertex] += element.load[i];
    system.mass[vertex] += element.area / 3.0;
    if (element.reacts) system.anchored[v] = 1;
  }
}

}  // namespace

AssembledSystem assemble(const Mesh& mesh, const Problem& problem, std::span<const double> crosswind) {
  std::vector<SourceMoments> loads = source_moments(mesh, problem);
  add_point_sources(mesh, problem, loads);
  AssembledSystem system;
  system.matrix = zero_matrix(mesh);
  system.load.setZero(mesh.num_vertices());
  system.mass.setZero(mesh.num_vertices());
  system.anchored.assign(mesh.points.size(), 0);
  system.symmetric = !problem.velocity;
  std::vector<ElementSystem> elements(mesh.triangles.size());
  for_each_in_parallel(elements.size(), [&](std::size_t t) {
    elements[t] = element_system(mesh, problem, t, loads.empty() ? SourceMoments{} : loads[t],
                                 crosswind.empty() ? 0.0 : crosswind[t]);
  });
  const Adjacency stars = vertex_triangles(mesh);
  for_each_in_parallel(mesh.points.size(),
                       [&](std::size_t v) { gather(mesh, stars, elements, static_cast<int>(v), system); });
  if (!elements.empty()) {
    const auto [low, high] = std::ranges::minmax_element(elements, {}, &ElementSystem::peclet);
    system.peclet_min = low->peclet;
    system.peclet_max = high->peclet;
  }
  system.definite = std::ranges::none_of(elements, &ElementSystem::negative);
  return system;
}

}  // namespace parmesan
