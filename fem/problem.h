#pragma once

#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <vector>

#include "fem/solver_options.h"
#include "mesher/errors.h"
#include "mesher/geometry/symmetric_tensor.h"
#include "mesher/mesh.h"

namespace parmesan {

/// A diffusion tensor; positive definite.
using Diffusion = SymmetricTensor;

/// Coefficients are functions of the point and of the region of the triangle it lies in.
using ScalarCoefficient = std::function<double(const Point&, int region)>;
using VectorCoefficient = std::function<Vector(const Point&, int region)>;
using DiffusionCoefficient = std::function<Diffusion(const Point&, int region)>;

/// Boundary data are functions of the point, the outward unit normal and the region inside.
using BoundaryData = std::function<double(const Point&, const Vector& normal, int region)>;

enum class BoundaryKind { Dirichlet, Neumann, Robin };

/// Dirichlet: u = value. Neumann: n.K grad u = value. Robin: n.K grad u + coefficient u = value.
struct BoundaryCondition {
  BoundaryKind kind = BoundaryKind::Dirichlet;
  BoundaryData value;
  BoundaryData coefficient;    // Robin only
  bool on_constraints = true;  // Dirichlet: interior constraints with the label are held, too
};

/// A source of this strength concentrated in a point: strength times the delta distribution.
struct PointSource {
  Point place;
  double strength = 0.0;  // U L^0 K: the flux out through any curve around it
};

/// The source written as f = remainder - div flux. A flux as rough as grad r^(1/10) can be integrated where its
/// divergence cannot, and it need not be continuous where K is not.
struct DivergenceForm {
  VectorCoefficient flux;
  ScalarCoefficient remainder;  // zero where empty
};

/// -div(K grad u) + b.grad u + c u = f + point sources, with one condition per boundary label. An empty velocity,
/// reaction or source is zero. Labels of interior constraints need no condition. SUPG needs the source itself: with a
/// velocity the divergence form is not looked at.
struct Problem {
  DiffusionCoefficient diffusion;
  VectorCoefficient velocity;
  ScalarCoefficient reaction;
  ScalarCoefficient source;
  std::optional<DivergenceForm> divergence_form;  // of the same source; the load is integrated from it
  std::vector<PointSource> point_sources;
  std::map<int, BoundaryCondition> boundary;
  bool stabilize = true;                 // SUPG where the mesh Peclet number exceeds 1
  bool capture_discontinuities = false;  // diffusion across the flow where layers are not resolved
  bool correct_defect = false;           // nodal values corrected for what Galerkin's method adds to the error
  SolverOptions solver;
};

/// The problem and its data contradict each other: a boundary part without a condition, pure
/// Neumann data that do not balance, a coefficient that is not finite or not positive. Exit code 3.
class ProblemError : public InputError {
 public:
  using InputError::InputError;
};

/// No solution with an acceptable residual was found. Exit code 6.
class SolveError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace parmesan
