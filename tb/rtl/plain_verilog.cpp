#include "tb/rtl/plain_verilog.h"

namespace cosim::rtl {

std::vector<std::string> plain_verilog(Sources sources, const std::filesystem::path& to) {
  if (!sources.blackboxes.empty()) sources.files = without_blackboxes(sources, to / "blackbox");
  return with_split_inouts(sources, to / "inout");
}

}  // namespace cosim::rtl
