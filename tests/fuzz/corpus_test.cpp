// Every file of each target's corpus, seeds and former findings, through what libFuzzer calls; and
// every file of JSON with each of its values changed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <ctime>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tb/util/json.h"
#include "tb/util/read_file.h"
#include "tests/fuzz/expect.h"

namespace cosim::fuzz {
namespace {

namespace fs = std::filesystem;

// The files of corpus/, a folder a target.
std::vector<fs::path> corpus() {
  std::vector<fs::path> files;
  for (const auto& [name, target] : targets()) {
    const std::size_t before = files.size();
    for (const auto& file : fs::directory_iterator(COSIM_CORPUS "/" + name)) files.push_back(file);
    if (files.size() == before) throw std::runtime_error(name + " has no corpus");
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string target_of(const fs::path& file) { return file.parent_path().filename(); }

// Seconds of processor time; the least of some, for others are at work.
double seconds_for(Target feed, const std::string& text) {
  double least = 1e9;
  for (int i = 0; i < 3; ++i) {
    timespec before{}, after{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &before);
    feed(text);
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &after);
    least = std::min(least, static_cast<double>(after.tv_sec - before.tv_sec) +
                                1e-9 * static_cast<double>(after.tv_nsec - before.tv_nsec));
  }
  return least;
}

// Values of every kind, small and huge; and deeper than is read.
const std::vector<std::string>& others() {
  static const std::vector<std::string> all = [] {
    std::istringstream words(R"(null true 0 7 -1 18446744073709551615 1e300 -0.5 [] {} [{}]
                                "" "\u001b[2J\n" 1e999 {"a":1,"a":2})");
    std::vector<std::string> texts{std::istream_iterator<std::string>(words), {}};
    texts.push_back("[7" + [] {
      std::string sevens;
      for (int i = 0; i < 1000; ++i) sevens += ",7";
      return sevens;
    }() + "]");
    for (const std::size_t deep : {most_json_levels + 0UL, 100'000UL}) {
      texts.push_back(std::string(deep, '[') + std::string(deep, ']'));
    }
    return texts;
  }();
  return all;
}

// Calls changed(text) for the file with each value another one, gone, or there twice.
template <class Changed>
void each_change(const Json& whole, const Json::json_pointer& at, const Changed& changed) {
  static const std::string mark = "here is another value";
  const auto with = [&](const Json& json) {
    const std::string text = json_text(json);
    for (const std::string& other : others()) {
      std::string one = text;
      one.replace(one.find('"' + mark + '"'), mark.size() + 2, other);
      changed(one);
    }
  };
  Json marked = whole;
  marked[at] = mark;
  with(marked);
  const Json& value = whole[at];
  if (!value.is_structured()) return;
  for (std::size_t i = 0; i < value.size(); ++i) {
    Json fewer = whole;
    if (value.is_array()) {
      fewer[at].erase(i);
      changed(json_text(fewer));
      each_change(whole, at / i, changed);
    } else {
      const std::string key = std::next(value.begin(), static_cast<std::ptrdiff_t>(i)).key();
      fewer[at].erase(key);
      changed(json_text(fewer));
      Json more = whole;
      more[at][key + 'x'] = mark;
      with(more);
      each_change(whole, at / key, changed);
    }
  }
}

class Corpus : public testing::TestWithParam<fs::path> {
 protected:
  std::string text() const { return read_file(GetParam().string()); }
  Target feed = targets().at(target_of(GetParam()));
};

TEST_P(Corpus, IsReadOrRefused) {
  taken = 0;
  feed(text());
  if (GetParam().stem() == "good") EXPECT_GT(taken, 0);
}

// Twice as much text takes twice the time, and not the square of it.
TEST_P(Corpus, RepeatedEightTimesTakesNotTheSquareOfTheTime) {
  constexpr std::size_t size = 65536;
  std::string all;
  while (all.size() < size) all += text() + (text().empty() ? "\n" : "");
  all.resize(size);
  constexpr double least = 1e-3;  // what is read in no time tells nothing
  EXPECT_LT(seconds_for(feed, all),
            32 * std::max(least, seconds_for(feed, all.substr(0, size / 8))));
}

// Those of the files that are JSON.
class JsonCorpus : public Corpus {};

bool is_json(const fs::path& path) {
  std::vector<std::string> errors;
  return parse_json(read_file(path), errors).is_structured() && errors.empty();
}

TEST_P(JsonCorpus, IsReadOrRefusedWithAnyValueChanged) {
  std::vector<std::string> errors;
  const std::string text = this->text();
  const Json whole = parse_json(text, errors);
  each_change(whole, Json::json_pointer(""), feed);
  for (std::size_t size = 0; size < text.size(); ++size) feed(text.substr(0, size));
}

std::string name_of(const testing::TestParamInfo<fs::path>& info) {
  std::string name = target_of(info.param) + '_' + info.param.stem().string();
  for (char& c : name) c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  return name;
}

std::vector<fs::path> json_corpus() {
  auto files = corpus();
  std::erase_if(files, [](const fs::path& path) { return !is_json(path); });
  return files;
}

INSTANTIATE_TEST_SUITE_P(Fuzz, Corpus, testing::ValuesIn(corpus()), name_of);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(JsonCorpus);
INSTANTIATE_TEST_SUITE_P(Fuzz, JsonCorpus, testing::ValuesIn(json_corpus()), name_of);

}  // namespace
}  // namespace cosim::fuzz
