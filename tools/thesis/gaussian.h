#pragma once

#include <memory>

#include "mesher/metric/metric_field.h"
#include "tools/thesis/experiment.h"

namespace parmesan::thesis {

/// exp(-|p - center|^2 / 2) of 5.6.1.
double gaussian_at(const Point& p, const Point& center = {});

/// The thesis's metric: its |Hessian| times a factor, eigenvalues at least 0.01 of the largest there is.
std::unique_ptr<MetricField> metric_of_thesis(double factor, const Point& center = {});

/// The metric that is best for the L2 error: det(|H|)^(-1/6) |H|, halved where det H < 0 (Loseille and Alauzet 2011,
/// and the sign's factor), times a factor; eigenvalues at least 0.001 of the largest.
std::unique_ptr<MetricField> metric_for_l2(double factor);

/// L2 norm of the error of linear interpolation of the Gaussian, by quadrature of degree 6 on four parts per triangle.
double interpolation_error(const Mesh& mesh);

/// A run whose number of vertices is about the one asked for: the factor is corrected a few times.
Run run_for_vertices(const Domain& domain, const std::function<std::unique_ptr<MetricField>(double)>& family,
                     double vertices, const GenerateOptions& options);

}  // namespace parmesan::thesis
