// Runs the built program with a shell's words and keeps what it says.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace cosim::test {

inline std::string slurp(const std::filesystem::path& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The lines of a text, each split at its commas.
inline std::vector<std::vector<std::string>> rows(const std::string& text) {
  std::vector<std::vector<std::string>> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    found.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) found.back().push_back(cell);
  }
  return found;
}

/// A folder of the test's own, and the program run in it.
class Command : public testing::Test {
 public:
  struct Said {
    int status = -1;  ///< the exit status, -1 where the program did not exit by itself
    std::string out, err;
  };

  Said run(const std::string& arguments) const {
    const std::string line = "cd '" + folder_.string() + "' && '" COSIM_PROGRAM "' " + arguments +
                             " > out.txt 2> err.txt < /dev/null";
    const int status = std::system(line.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, slurp(folder_ / "out.txt"),
            slurp(folder_ / "err.txt")};
  }
  std::filesystem::path file(const std::string& name) const { return folder_ / name; }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }

 protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "cosim.XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

 private:
  std::filesystem::path folder_;
};

}  // namespace cosim::test
