#pragma once

#include <string>

namespace parmesan {

/// All keys of a case file in Markdown, as case_schema() has them: a section for each kind of object, in the order in
/// which they are met, with its keys, their types, defaults and descriptions in a table.
std::string case_schema_page();

}  // namespace parmesan
