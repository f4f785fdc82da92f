// A run as one HTML file: for a browser on a machine that has nothing else. It needs no network and
// no script, is under a megabyte, and has the colours that the reader's system asks for.
#pragma once

#include <string>
#include <vector>

#include "tb/report/report.h"
#include "tb/wave/picture.h"

namespace cosim {

struct Page {
  /// A run to look at.
  struct Part {
    std::string heading;
    std::string text{};  ///< lines
    WavePicture picture{};
    std::string stimulus{};  ///< its file, or ""
  };
  /// What one may do next.
  struct Command {
    std::string words;  ///< as typed
    std::string what;   ///< it does
  };

  std::vector<Outcome> outcomes;
  std::vector<Part> parts{};  ///< those that show no clock are left out
  std::vector<Command> commands{};
};

/// The file. What is too long for it is cut, and it says so.
std::string page_text(const Page& page);

}  // namespace cosim
