// A wave read back, by way of GTKWave's fst2vcd: a reader for tests, of what the writer has no part
// in.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace cosim::test {

/// True where fst2vcd is installed.
inline bool can_read_waves() { return std::system("command -v fst2vcd > /dev/null 2>&1") == 0; }

class Vcd {
 public:
  /// Of the FST file `path`.
  explicit Vcd(const std::string& path) {
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(
        popen(("fst2vcd '" + path + "' 2> /dev/null").c_str(), "r"), pclose);
    std::string text;
    char block[4096];
    for (std::size_t n; pipe && (n = std::fread(block, 1, sizeof block, pipe.get())) > 0;) {
      text.append(block, n);
    }
    read(text);
  }

  bool has(const std::string& signal) const { return codes_.contains(signal); }
  std::size_t size() const { return codes_.size(); }
  std::uint64_t end() const { return end_; }

  /// The bits, or the number of a real, or the text, that the signal has at a time; none before its
  /// first.
  std::optional<std::string> at(const std::string& signal, std::uint64_t time) const {
    const auto code = codes_.find(signal);
    if (code == codes_.end()) return {};
    const auto& changes = changes_.at(code->second);
    const auto next = changes.upper_bound(time);
    if (next == changes.begin()) return {};
    return std::prev(next)->second;
  }

 private:
  void read(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> scopes;
    std::uint64_t time = 0;
    for (std::string word; in >> word;) {
      if (word == "$scope") {
        std::string kind, name;
        in >> kind >> name;
        scopes.push_back(name);
      } else if (word == "$upscope") {
        scopes.pop_back();
      } else if (word == "$var") {
        std::string kind, width, code, name;
        in >> kind >> width >> code >> name;
        std::string full;
        for (const std::string& scope : scopes) full += scope + ".";
        codes_[full + name] = code;
        changes_[code];
      } else if (word[0] == '#') {
        end_ = time = std::stoull(word.substr(1));
      } else if (word[0] == 'b' || word[0] == 'r' || word[0] == 's') {
        std::string code;
        in >> code;
        if (changes_.contains(code)) changes_[code][time] = word.substr(1);
      } else if ((word[0] == '0' || word[0] == '1' || word[0] == 'x') && word.size() > 1 &&
                 changes_.contains(word.substr(1))) {
        changes_[word.substr(1)][time] = word.substr(0, 1);
      }
    }
  }

  std::map<std::string, std::string> codes_;
  std::map<std::string, std::map<std::uint64_t, std::string>> changes_;
  std::uint64_t end_ = 0;
};

}  // namespace cosim::test
