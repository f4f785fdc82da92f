// The RTL of a project that `cosim new` begins.
#pragma once

#include <string>
#include <vector>

#include "tb/cli/command.h"
#include "tb/new/found.h"
#include "tb/util/draft.h"

namespace cosim::cli {

/// What is typed behind `cosim new`.
struct NewOptions {
  std::vector<std::string> words;  ///< the name, then files and folders
  bool plain = false, stream = false;
  Text top, clock, reset;
  std::vector<std::string> includes, libraries, defines, parameters, blackboxes, lists, own_lists;
};

struct BegunProject {
  Found found;
  std::vector<std::string> sources, left_out;
  std::string headers;  ///< their folder
  bool top_is_guessed = false;
  std::vector<std::string> defines;
  std::vector<std::string> notes;  ///< what was done for it to be read
};

/// Copies what the design needs, and reads it there: by those names every program can be given
/// them. InputError, one line.
BegunProject begin_project(const NewOptions& o, const Draft& project);

}  // namespace cosim::cli
