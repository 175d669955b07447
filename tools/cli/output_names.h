#pragma once

#include <string>
#include <vector>

namespace parmesan {

/// What is wrong with names of outputs: one is a file that is read, so that what was given would be lost, or stands
/// for the same file as another. Empty: nothing. Names of nothing are passed by. Triangle's .node and .ele stand for
/// both, and .edge.
std::string clash_of_names(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs);

}  // namespace parmesan
