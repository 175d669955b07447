#pragma once

#include <filesystem>
#include <iostream>
#include <optional>
#include <string>

namespace parmesan::support {

/// The folder of shared test inputs beside the checkout; prints why a test is skipped when absent.
inline std::optional<std::string> shared_dir() {
  const std::filesystem::path dir = std::filesystem::path(PARMESAN_SOURCE_DIR).parent_path() / "shared";
  if (std::filesystem::is_directory(dir)) return dir.string();
  std::cout << "skipped: ../shared is not beside the checkout\n";
  return std::nullopt;
}

}  // namespace parmesan::support
