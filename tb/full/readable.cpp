#include "tb/full/readable.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "model/core/input_error.h"
#include "tb/cli/registry.h"
#include "tb/equiv/front_end.h"
#include "tb/equiv/misread.h"
#include "tb/rtl/plain_verilog.h"
#include "tb/util/hash.h"
#include "tb/util/output_file.h"
#include "tb/util/read_file.h"

namespace cosim::cli {
namespace {

namespace fs = std::filesystem;

constexpr int time_for_slang = 60;  // seconds

// Copies in the build folder of the files that yosys would read in part.
void reveal(proof::Source& source) {
  for (fs::path& file : source.files) {
    const std::string text = read_file(file.string()), whole = equiv::revealed(text);
    if (whole == text) continue;
    const fs::path copy =
        fs::path(registry().build_folder()) / "revealed" / hash_of(text) / file.filename();
    fs::create_directories(copy.parent_path());
    write_file(copy.string(), whole);
    source.include_dirs.push_back(fs::absolute(file).parent_path());
    file = copy;
  }
}

}  // namespace

equiv::Files files_of(const proof::Source& source) {
  equiv::Files files;
  files.files = source.files;
  files.top = source.top;
  for (const Parameter& p : source.parameters) {
    const auto given = source.constants.find(p.name);
    files.parameters.push_back(
        fmt::format("{}={}", p.name, given == source.constants.end() ? to_text(p) : given->second));
  }
  files.include_dirs = source.include_dirs;
  files.defines = source.defines;
  if (source.files.size() == 1) files.vhdl = rtl::vhdl_of(source.files.front());
  return files;
}

std::string hash_of_rtl(const proof::Source& source) {
  std::set<fs::path> folders(source.include_dirs.begin(), source.include_dirs.end()), all;
  for (const fs::path& file : source.files) {
    all.insert(file);
    folders.insert(fs::absolute(file).parent_path());
  }
  constexpr std::uintmax_t most = 10'000'000;  // bytes of what is read beside the sources
  for (const fs::path& folder : folders) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      if (entry.is_regular_file() && entry.file_size() < most) all.insert(entry.path());
    }
  }
  for (const fs::path& file : files_of(source).vhdl) all.insert(file);
  std::string key = proof::commands_to_elaborate(source);
  for (const fs::path& file : all) key += file.string() + hash_of_file(file.string());
  return hash_of(key);
}

proof::Source readable(proof::Source source) {
  reveal(source);
  const bool is_verilog = std::ranges::none_of(
      source.files, [](const fs::path& file) { return file.extension() == ".sv"; });
  if (is_verilog || !source.written.empty()) return source;
  const fs::path kept =
      fs::path(registry().build_folder()) / "slang" / (hash_of_rtl(source) + ".v");
  if (!fs::exists(kept)) {
    try {
      proof::run_yosys(proof::commands_to_elaborate(source) + "; proc", source.top);
      return source;
    } catch (const InputError& error) {
      if (!equiv::has_slang()) throw InputError(error.what() + equiv::slang_hint());
    }
    std::string text;
    try {
      text = equiv::verilog_by_slang(files_of(source), source.top, equiv::Budget(time_for_slang));
    } catch (const equiv::OutOfTime&) {
      throw InputError(
          fmt::format("{}: slang does not read it in {} s", source.top, time_for_slang));
    }
    fs::create_directories(kept.parent_path());
    write_file(kept.string(), text);
  }
  source.written = kept;
  return source;
}

}  // namespace cosim::cli
