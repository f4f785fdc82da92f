#include "tests/careless/scratch.h"

#include <sys/stat.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace cosim::careless {

namespace fs = std::filesystem;

const std::vector<std::string>& input_names() {
  static const std::vector<std::string> all{
      "../in/good.ngc", "../in/good.ngc", "../in/good.stim", "../in/good.stim", "../in/empty",
      "../in/bytes",    "../in/folder",   "../in/pipe",      "../in/nowhere",   "../in/link",
      "../in/json",     "../in/rtl",      "../in/none",      "../in/plan",      "../in/deep"};
  return all;
}

Scratch::Scratch(const fs::path& root) {
  std::string name = (fs::temp_directory_path() / "careless.XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no scratch folder");
  folder_ = name;
  for (const char* part : {"in", "work", "work/sub", "tmp", "home", "in/folder"}) {
    fs::create_directory(folder_ / part);
  }
  const fs::path in = folder_ / "in";
  fs::copy_file(root / "tests/toolpaths/flange.ngc", in / "good.ngc");
  fs::copy_file(root / "tests/regressions/tick_carry.stim", in / "good.stim");
  fs::copy(root / "rtl", in / "rtl", fs::copy_options::recursive);
  std::ofstream(in / "empty");
  std::ofstream(in / "bytes", std::ios::binary) << std::string("\0\xff\x01(\n%G1 X\x80", 12);
  std::ofstream(in / "json") << "{\"work\":\"other\",\"state\":[]}\n";
  std::ofstream(in / "deep") << std::string(100'000, '[');
  std::ofstream(in / "plan") << R"~({"format": 1, "name": "n", "tasks": [
    {"name": "b", "run": ["true", "$(touch pwned)"]},
    {"name": "c; touch pwned", "run": ["false"]}]})~";
  fs::create_symlink("nothing/here", in / "nowhere");
  fs::create_symlink("good.ngc", in / "link");
  if (mkfifo((in / "pipe").c_str(), 0600) != 0) throw std::runtime_error("no pipe");
}

Scratch::~Scratch() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

std::map<std::string, std::string> Scratch::holds() const {
  constexpr std::uintmax_t longest = 1U << 20;
  std::map<std::string, std::string> all;
  for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
    std::string& held = all[entry.path().lexically_relative(folder_).string()];
    if (entry.is_symlink()) {
      held = "link to " + fs::read_symlink(entry.path()).string();
    } else if (entry.is_regular_file()) {
      std::ifstream file(entry.path(), std::ios::binary);
      const std::uintmax_t size = entry.file_size();
      if (size > longest) file.seekg(static_cast<std::streamoff>(size - longest));
      held = std::to_string(size) + ": " + std::string(std::istreambuf_iterator<char>(file), {});
    } else {
      held = entry.is_directory() ? "folder" : "other";
    }
  }
  return all;
}

}  // namespace cosim::careless
