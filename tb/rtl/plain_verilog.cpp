#include "tb/rtl/plain_verilog.h"

#include <algorithm>
#include <fstream>

#include "tb/rtl/files.h"
#include "tb/rtl/vhdl.h"

namespace cosim::rtl {

bool is_vhdl(const std::filesystem::path& file) {
  return file.extension() == ".vhd" || file.extension() == ".vhdl";
}

std::vector<std::filesystem::path> vhdl_of(const std::filesystem::path& made) {
  std::vector<std::filesystem::path> files;
  if (made.filename() != "vhdl.v") return files;
  std::ifstream list(made.parent_path() / "vhdl.files");
  for (std::string line; std::getline(list, line);) files.emplace_back(line);
  return files;
}

std::vector<std::string> plain_verilog(Sources sources, const std::filesystem::path& to,
                                       const Run& run) {
  Sources vhdl = sources;
  std::erase_if(vhdl.files, [](const std::string& file) { return !is_vhdl(file); });
  if (!vhdl.files.empty()) {
    const std::string made = verilog_of_vhdl(vhdl, to / "ghdl", run);
    std::string list;
    if (vhdl.files.size() == sources.files.size()) {
      for (const std::string& file : vhdl.files) {
        list += std::filesystem::absolute(vhdl.folder / file).string() + '\n';
      }
    }
    std::erase_if(sources.files, is_vhdl);
    sources.files.push_back((to / "vhdl.v").string());
    write_text(sources.files.back(), made);
    write_text(to / "vhdl.files", list);
  }
  if (!sources.blackboxes.empty()) sources.files = without_blackboxes(sources, to / "blackbox");
  return with_split_inouts(sources, to / "inout");
}

}  // namespace cosim::rtl
