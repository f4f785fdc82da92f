// Files that are read whole or not at all.
#include "tb/util/read_file.h"

#include <sys/stat.h>

#include <filesystem>

#include "tests/support/error_of.h"
#include "tests/support/folder.h"

namespace cosim {
namespace {

namespace fs = std::filesystem;

using ReadFile = test::InAFolder;

std::string error_of(const std::string& path) {
  return test::error_of([&] { read_file(path); });
}

TEST_F(ReadFile, GivesEveryByte) {
  const std::string bytes("\r\n\0\xff\x1a end", 9);
  EXPECT_EQ(read_file(folder.write("bytes", bytes)), bytes);
  EXPECT_EQ(read_file(folder.write("empty", "")), "");
  const std::string large(300'000, 'x');
  EXPECT_EQ(read_file(folder.write("large", large)), large);
}

TEST_F(ReadFile, SaysWhyItCannot) {
  EXPECT_EQ(error_of(folder.path("none")), folder.path("none") + ": no such file");
  EXPECT_EQ(error_of(folder.path("")), folder.path("") + ": is a directory, not a file");
  ASSERT_EQ(mkfifo(folder.path("pipe").c_str(), 0600), 0);
  EXPECT_EQ(error_of(folder.path("pipe")), folder.path("pipe") + ": is not a regular file");
  EXPECT_EQ(error_of("/dev/null"), "/dev/null: is not a regular file");
  EXPECT_EQ(error_of(std::string(100000, 'a')).substr(100000),
            ": cannot be read: File name too long");
  const std::string under = folder.write("file", "text") + "/x";
  EXPECT_TRUE(error_of(under).starts_with(under + ": "));
}

TEST_F(ReadFile, RefusesMoreThanTheLimit) {
  const std::string large = folder.write("large", "text");
  fs::resize_file(large, max_file_bytes + 1);  // a hole: takes no space
  EXPECT_EQ(error_of(large), large + ": is larger than 256 MiB");
}

}  // namespace
}  // namespace cosim
