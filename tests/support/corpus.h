#pragma once

#include <string>
#include <vector>

#include "mesher/geometry/domain.h"

namespace parmesan::support {

/// One row of the exact classification of the shared geometries, with what CGAL makes of it.
struct CorpusEntry {
  std::string file;  // relative to the corpus
  std::string kind;  // valid-plc, repairable, invalid-crossing
  int points = 0;
  int segments = 0;
  int duplicate_points = 0;
  int triangles = 0;  // constrained Delaunay triangles inside by the even-odd rule
  double area = 0.0;  // theirs, to six digits
};

/// CLASSES.csv joined with REFERENCE_CGAL.csv, in the order of the first.
std::vector<CorpusEntry> corpus_entries(const std::string& corpus);

/// The geometry in a file of the corpus, whichever of its formats: rings become closed chains of
/// segments, each with a label of its own from 1; inside is what the even-odd rule says.
/// Errors: std::runtime_error for a file without points.
Domain read_corpus_file(const std::string& path);

}  // namespace parmesan::support
