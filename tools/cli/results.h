#pragma once

#include <iosfwd>
#include <span>
#include <string>

#include "adapt/run_case.h"
#include "mesher/generate.h"
#include "mesher/io/mesh_fields.h"
#include "mesher/quality.h"

namespace parmesan {

/// Why a run ended, what its last mesh is worth, and where its files are.
void print_summary(std::ostream& out, const RunResult& result);

/// Prints one line per pass limit; true when all hold.
bool all_passed(std::ostream& out, std::span<const Verdict> verdicts);

/// Warns of what readers of a mesh that has been written will miss or mistake: notes_on_written.
void warn_of_written(const std::string& path, const Mesh& mesh, const MeshFields& fields = {});

/// Counts, lengths, quality and start of a mesh in three lines.
void print_mesh_summary(std::ostream& out, const GenerateResult& made, const MeshQuality& quality);

}  // namespace parmesan
