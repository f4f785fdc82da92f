// Every file of a target's corpus, seeds and former findings, through the function that libFuzzer
// calls.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "tb/support/read_file.h"
#include "tests/fuzz/expect.h"

namespace cosim::fuzz {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> corpus() {
  std::vector<fs::path> files{fs::directory_iterator(COSIM_CORPUS), {}};
  if (files.empty()) throw std::runtime_error(COSIM_CORPUS " is empty");
  std::sort(files.begin(), files.end());
  return files;
}

void feed(const std::string& text) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
}

class Corpus : public testing::TestWithParam<fs::path> {
 protected:
  std::string text() const { return read_file(GetParam().string()); }
};

TEST_P(Corpus, IsReadOrRefused) { feed(text()); }

TEST_P(Corpus, RepeatedTo64KilobytesTakesLessThanASecond) {
  constexpr std::size_t size = 65536;
  std::string all;
  while (all.size() < size) all += text() + (text().empty() ? "\n" : "");
  all.resize(size);
  const auto start = std::chrono::steady_clock::now();
  feed(all);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1));
}

std::string name_of(const testing::TestParamInfo<fs::path>& info) {
  std::string name = info.param.stem().string();
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Corpus, testing::ValuesIn(corpus()), name_of);

}  // namespace
}  // namespace cosim::fuzz
