#pragma once

#include <string>

#include "adapt/case.h"
#include "adapt/folder_lock.h"
#include "adapt/iterate.h"
#include "adapt/summary.h"

namespace parmesan {

/// What is to become of an earlier run's files in a folder.
enum class EarlierFiles {
  Refuse,   // there must not be any, nor others
  Replace,  // they are removed; what is not ours is left alone
  GoOn      // the final ones are removed; iterations and checkpoints stay
};

/// Makes an output folder, or takes an existing one, and locks it.
///
/// Errors: FileError when something else than a folder has the name, when another process has locked it, when
/// the folder holds files and they are refused, or when it cannot be made.
FolderLock prepare_folder(const std::string& path, EarlierFiles earlier);

/// Removes an earlier run's files, when there is something to put in their place. Errors: FileError.
void remove_earlier_files(const std::string& path, EarlierFiles earlier);

/// The folder of a run, filled as the run goes on (adapt/README, "The folder of a run").
///
/// The files of the whole run (mesh.*, with names in .msh, the solution in .vtu, .msh and .sol; run.pvd, summary.json)
/// are written by finish() only, each complete or not at all; a run that fails leaves its case and its iterations,
/// never a summary. One that fails before its first iteration is done leaves what it found: an earlier run that it
/// should replace, or nothing, so that the next needs no leave to overwrite it.
class RunFolder {
 public:
  /// Errors: as prepare_folder.
  RunFolder(const std::string& path, const Case& input, EarlierFiles earlier);

  const std::string& path() const { return path_; }

  /// iterations/NNN/, in the formats the case asks for; case.json before the first, in place of earlier files. Errors:
  /// FileError.
  void write_iteration(const Iterate& iterate, const IterationRow& row);

  /// The final files; summary.json last. Errors: FileError.
  void finish(const Summary& summary, const Iterate& last);

 private:
  void begin();
  bool wants(const std::string& format) const;
  std::string file(const std::string& name) const { return path_ + "/" + name; }

  std::string path_;
  FolderLock lock_;
  const Case& case_;
  EarlierFiles earlier_;
  bool has_begun_ = false;
};

}  // namespace parmesan
