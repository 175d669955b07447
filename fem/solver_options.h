#pragma once

namespace parmesan {

/// How A x = b is solved.
enum class SolverMethod { Automatic, Ldlt, Lu, Cg, BiCgStab, Gmres };

/// What an iterative method is preconditioned with.
enum class Preconditioner { Automatic, Jacobi, IncompleteLu, Multigrid };

/// What is wished of the linear solver; README.md has what is automatic, by the size and the kind of the matrix.
struct SolverOptions {
  SolverMethod method = SolverMethod::Automatic;
  Preconditioner preconditioner = Preconditioner::Automatic;  // of iterative methods
  int restart = 50;                                           // vectors that GMRES keeps, 1 to 1000
};

}  // namespace parmesan
