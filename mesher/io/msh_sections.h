#pragma once

#include <map>
#include <utility>

#include "mesher/io/msh_content.h"
#include "mesher/io/msh_input.h"

namespace parmesan {

/// The first physical group of each entity, by dimension and tag; 0 where it has none.
using MshEntityGroups = std::map<std::pair<int, int>, int>;

/// Each reads what a section of a Gmsh file holds, after its name, in the way of the file's format and encoding.
/// Errors: FileError.
void read_msh_names(MshInput& in, MshContent& content);
void read_msh_nodes(MshInput& in, MshContent& content);
void read_msh_elements(MshInput& in, const MshEntityGroups& groups, MshContent& content);
MshEntityGroups read_msh_entities(MshInput& in);
MshField read_msh_field(MshInput& in);

/// The number of a physical group: negative ones are Gmsh's way to say that elements are turned.
int read_msh_group(MshInput& in, const char* what);

}  // namespace parmesan
