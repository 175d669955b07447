#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fem/norms.h"
#include "mesher/mesh.h"

namespace parmesan {

/// A P1 function given by its values at the vertices of a mesh.
struct GivenField {
  Mesh mesh;
  std::vector<double> values;
};

/// The function and its gradient, constant on each triangle; outside of the mesh a place of it nearby decides.
/// For one thread at a time: it is looked up from the place before.
ExactFunction function_of(const std::shared_ptr<const GivenField>& field);

/// A warning where a mesh of the case's domain reaches beyond the field's by more than a thousandth of that one's size.
std::optional<std::string> warn_beyond(const GivenField& field, const Mesh& mesh);

}  // namespace parmesan
