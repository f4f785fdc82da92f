// Misspelt names in a model, which would silently be nothing: the harness finds by its name what a
// model may have beside its step.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cosim::rtl {

/// Reads the headers of a model and what they include with "...". InputError where a function, a
/// type or a constant of a struct that has In, or that names a stream, nearly has a name of what a
/// model may say (model/clocked/says.h), which the headers of the harness below `root` ask for.
/// That is one edit away (a letter put in, left out, changed or swapped with the next one) from a
/// name of 4 to 9 letters, two edits from a longer one. Writes `stamp`, and `stamp`.d for ninja:
/// the files that were read.
void check_names(const std::string& stamp, const std::filesystem::path& root,
                 const std::vector<std::string>& headers);

}  // namespace cosim::rtl
