#pragma once

#include <string>
#include <vector>

namespace parmesan {

/// Writes one self-contained HTML page about runs and comparisons, from what they left in their folders
/// (case.json, summary.json and the last checkpoint).
///
/// The page loads nothing: its scripts, styles and data are inside, and a content security policy lets no others
/// run. Whatever names and titles hold, they only ever become text.
/// Returns what it lacks, one sentence each: meshes of runs without a checkpoint that can be read.
/// Errors: FileError (a folder has no finished run or comparison, or the page cannot be written).
std::vector<std::string> write_report(const std::string& path, const std::vector<std::string>& folders);

}  // namespace parmesan
