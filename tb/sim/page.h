// A run as one HTML file: for a browser on a machine that has nothing else. It needs no network and
// no script, is under a megabyte, and has the colours that the reader's system asks for.
#pragma once

#include <string>
#include <vector>

#include "tb/show/picture.h"
#include "tb/sim/report.h"

namespace cosim {

struct Page {
  /// Something to look at.
  struct Part {
    std::string heading;
    std::string text{};      ///< lines
    WavePicture picture{};   ///< of a run, or of none
    std::string stimulus{};  ///< its file, or ""
    std::string table{};     ///< lines whose columns stand below each other, or ""
    std::string image{};     ///< the name of a file, .png or .svg, that goes into the page, or ""
  };
  /// What one may do next.
  struct Command {
    std::string words;  ///< as typed
    std::string what;   ///< it does
  };

  /// A verdict on what no bench runs.
  struct Verdict {
    std::string word;          ///< "equal"; empty: there are outcomes
    std::string kind;          ///< "good", "bad" or "none"
    std::string lines{};       ///< what was found
    std::string conditions{};  ///< under which it holds, lines
  };

  std::vector<Outcome> outcomes;
  std::vector<Part> parts{};  ///< those that show nothing are left out
  std::vector<Command> commands{};
  std::string title{};  ///< of what has more outcomes than one, or none
  Verdict verdict{};    ///< of what has none
};

/// The file. What is too long for it is cut, and it says so. InputError where an image cannot be
/// read.
std::string page_text(const Page& page);

}  // namespace cosim
