#pragma once

#include "mesher/particles/particle_options.h"

namespace parmesan {

/// One of the potentials of thesis 3.3, by the derivative phi' that forces need. The signs lost in print are put
/// back: phi' > 0 repels, phi' < 0 attracts, so that 3.20 keeps particles apart when nearer than 1.
class Potential {
 public:
  Potential(PotentialKind kind, double decay) : kind_(kind), decay_(decay) {}

  /// phi'(l) at the metric distance l > 0.
  double derivative(double l) const;

 private:
  PotentialKind kind_;
  double decay_;  // d of 3.20
};

/// The step delta of 3.12 that brings a displaced particle of the hexagonal lattice back at once, its neighbours
/// fixed: 1 / (-6 sum (phi'' + phi' / l)) over the rings of six at l = 1, sqrt3, 2, 3 that the neighbourhood has.
/// For 3.20 with d = 1 over N1: e / 24. Where more rings push the particle away, the step of N1.
double newton_step(const Potential& potential, Neighbourhood neighbourhood, double radius);

}  // namespace parmesan
