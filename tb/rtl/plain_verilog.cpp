#include "tb/rtl/plain_verilog.h"

#include <algorithm>

#include "tb/rtl/files.h"
#include "tb/rtl/vhdl.h"

namespace cosim::rtl {

bool is_vhdl(const std::filesystem::path& file) {
  return file.extension() == ".vhd" || file.extension() == ".vhdl";
}

std::vector<std::string> plain_verilog(Sources sources, const std::filesystem::path& to,
                                       const Run& run) {
  Sources vhdl = sources;
  std::erase_if(vhdl.files, [](const std::string& file) { return !is_vhdl(file); });
  if (!vhdl.files.empty()) {
    const std::string made = verilog_of_vhdl(vhdl, to / "ghdl", run);
    std::erase_if(sources.files, is_vhdl);
    sources.files.push_back((to / "vhdl.v").string());
    write_text(sources.files.back(), made);
  }
  if (!sources.blackboxes.empty()) sources.files = without_blackboxes(sources, to / "blackbox");
  return with_split_inouts(sources, to / "inout");
}

}  // namespace cosim::rtl
