#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "adapt/case.h"
#include "adapt/iterate.h"
#include "adapt/summary.h"

namespace parmesan {

/// Makes an output folder, or takes an existing one.
///
/// Errors: FileError when something else than a folder has the name, when the folder holds files and
/// overwrite is off, or when it cannot be made.
void prepare_folder(const std::string& path, bool overwrite);

/// The folder of a run, filled as the run goes on (INTERFACE: "What a run leaves in its folder").
///
/// The files of the whole run (mesh.*, run.pvd, summary.json) are written by finish() only, each
/// complete or not at all; a run that fails leaves its case and its iterations, never a summary.
class RunFolder {
 public:
  /// overwrite: files of an earlier run in the folder are removed; what is not ours is left alone.
  /// Errors: as prepare_folder, and FileError when case.json cannot be written.
  RunFolder(const std::string& path, const Case& input, bool overwrite);

  const std::string& path() const { return path_; }

  /// iterations/NNN/, in the formats the case asks for. Errors: FileError.
  void write_iteration(const Iterate& iterate, const IterationRow& row);

  /// The final files; summary.json last. Errors: FileError.
  void finish(const Summary& summary, const Iterate& last) const;

 private:
  bool wants(const std::string& format) const;
  std::string file(const std::string& name) const { return path_ + "/" + name; }

  std::string path_;
  const Case& case_;
  std::size_t num_iterations_ = 0;
};

}  // namespace parmesan
