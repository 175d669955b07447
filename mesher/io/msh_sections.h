#pragma once

#include <map>
#include <optional>
#include <utility>

#include "mesher/io/msh_content.h"
#include "mesher/io/msh_input.h"

namespace parmesan {

/// The groups of the elements of each entity, by dimension and tag: its first physical group, or 0, and its tag, that
/// of its parent where it is a part of that. Nothing where it is a border that partitioning has made.
using MshEntityGroups = std::map<std::pair<int, int>, std::optional<MshGroup>>;

/// Each reads what a section of a Gmsh file holds, after its name, in the way of the file's format and encoding.
/// Errors: FileError.
void read_msh_names(MshInput& in, MshContent& content);
void read_msh_nodes(MshInput& in, MshContent& content);
void read_msh_elements(MshInput& in, const MshEntityGroups& groups, MshContent& content);
void read_msh_entities(MshInput& in, MshEntityGroups& groups);
void read_msh_partitioned_entities(MshInput& in, MshEntityGroups& groups);
MshField read_msh_field(MshInput& in);

/// The number of a physical group: negative ones are Gmsh's way to say that elements are turned.
int read_msh_group(MshInput& in, const char* what);

}  // namespace parmesan
