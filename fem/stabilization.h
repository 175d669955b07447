#pragma once

#include "fem/p1.h"
#include "fem/problem.h"

namespace parmesan {

/// Length of the element in the direction of b, its longest chord along b (Tezduyar & Park 1986):
///
///     h_b = 2 |b| / sum_i |b . grad phi_i|.
///
/// Short across a stretched element and long along it, as in Micheletti, Perotto & Picasso,
/// SIAM J. Numer. Anal. 41 (2003) 1131. Units: L. Errors: none; infinite for b = 0.
double directional_length(const P1Element& element, const Vector& b);

/// Mesh Peclet number |b| h_b / (2 K_b) with K_b = b.K b / |b|^2; zero for b = 0.
double mesh_peclet(const P1Element& element, const Vector& b, const Diffusion& k);

/// Parameter of SUPG, tau = 2 h_b / (3 |b|) max(0, 1 - 1 / Pe) (critical approximation of Brooks &
/// Hughes, CMAME 32 (1982) 199). The factor 2/3 in place of their 1/2 is that of Knobloch, Adv. Comput.
/// Math. 31 (2009) 369, for triangles with one vertex on the outflow: the smallest for which the
/// layer there does not reach into the domain. README.md has the overshoots measured with both.
/// Zero where Pe <= 1.
///
/// Never more than the time 1 / sum_i grad phi_i . K grad phi_i in which diffusion crosses the element
/// the short way. P1 residuals lack div(K grad u), so tau times the error of what recovered_diffusion.h puts in its
/// place is one of consistency: in a layer along b, with elements long in b and thin across it, it would be of order
/// h_b times that. The bound acts only on such elements. Units: L^2 / K.
double supg_parameter(const P1Element& element, const Vector& b, const Diffusion& k);

}  // namespace parmesan
