#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesher/mesh.h"
#include "mesher/particles/particle_system.h"

namespace parmesan {

/// Writes how a mesh came to be: frames for ParaView and a page that plays them.
///
/// The folder, which is made if it is not there, gets frame_000.vtu, ..., evolution.pvd and index.html, in place of
/// those of an earlier evolution, by whose list it is known. The page is self-contained. Frames are taken at steps that
/// grow by a factor, so that a run has about a hundred, and at the end.
class EvolutionWriter {
 public:
  /// Errors: FileError when the folder cannot be made, or has files but no earlier evolution.
  explicit EvolutionWriter(std::string folder);

  /// To be given to GenerateOptions::observer; writes a frame where one is due. Errors: FileError.
  void see(const ParticleSystem& particles, std::int64_t step);

  /// Adds the last mesh and writes the page and the list. Errors: FileError.
  void finish(const Mesh& last);

 private:
  void add(const Mesh& mesh, std::int64_t step);

  std::string folder_;
  std::int64_t next_step_ = 0;
  std::int64_t last_step_ = 0;
  std::vector<std::int64_t> steps_;
  std::string frames_;  // for the page: one JavaScript object per frame
};

}  // namespace parmesan
