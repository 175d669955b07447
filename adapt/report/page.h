#pragma once

#include <string_view>

namespace parmesan {

/// The parts of the page, from the files beside this one (embedded when the project is configured).
struct ReportPage {
  std::string_view style;       // content of its <style>
  std::string_view script;      // content of its <script>
  std::string_view style_hash;  // SHA-256 in base64, for the content security policy
  std::string_view script_hash;
};

extern const ReportPage report_page;

}  // namespace parmesan
