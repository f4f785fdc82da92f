#include "tb/new/files_read.h"

#include <filesystem>
#include <set>

#include "model/core/input_error.h"
#include "tb/new/verilog_words.h"
#include "tb/util/read_file.h"

namespace cosim::cli {

std::vector<std::string> files_read(const std::vector<std::string>& files,
                                    const std::vector<std::string>& folders) {
  namespace fs = std::filesystem;
  std::vector<std::string> all = files;
  std::set<std::string> met(files.begin(), files.end());
  const auto add = [&](const fs::path& file) {
    std::error_code error;
    if (fs::is_regular_file(file, error) && met.insert(file.string()).second) all.push_back(file);
  };
  for (std::size_t i = 0; i < all.size(); ++i) {
    VerilogText words;
    try {
      words = verilog_words(read_file(all[i]));
    } catch (const InputError&) {
      continue;
    }
    words.headers.insert(words.headers.end(), words.data.begin(), words.data.end());
    for (const std::string& name : words.headers) {
      add(name);
      add(fs::path(all[i]).parent_path() / name);
      for (const std::string& folder : folders) add(fs::path(folder) / name);
    }
  }
  return all;
}

}  // namespace cosim::cli
