// The classes of a design whose whole hierarchy is open, as a library of its own. Only replays and
// waves need it: it is built when one first asks for it.
#pragma once

#include "tb/dut/open_instance.h"

namespace cosim {

struct OpenLibrary {
  const char* file;    ///< its path; the name has a hash of what it is made of
  const char* target;  ///< what makes it in the build folder
  const char *cmake, *build_folder;
};

/// What makes instances of the shape's class; `id` is that of the shape's Trait. Any thread may
/// call it. InputError where the library cannot be built, and where the RTL is no longer what the
/// program was built with.
MakeOpen open_maker_in(const OpenLibrary& library, const char* id);

}  // namespace cosim
