#include "tb/nets/blif.h"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "model/core/input_error.h"
#include "tb/util/words.h"

namespace cosim::nets {
namespace {

constexpr std::size_t kMostInputs = 6;

class Reader {
 public:
  explicit Reader(const std::string& what) : what_(what) {}

  Cells read(std::string_view text) {
    std::string line;
    for (std::string more : lines_in(text)) {
      ++number_;
      more.resize(std::min(more.find('#'), more.size()));
      line += more;
      if (line.ends_with('\\')) {
        line.back() = ' ';
        continue;
      }
      read_line(std::exchange(line, {}));
    }
    require_drivers();
    in_order();
    return std::move(cells_);
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw InputError(fmt::format("{}: line {}: {}", what_, number_, why));
  }

  std::size_t net(const std::string& name) {
    const auto [at, is_new] = numbers_.try_emplace(name, cells_.nets.size());
    if (is_new) {
      cells_.nets.push_back(name);
      is_driven_.push_back(false);
    }
    return at->second;
  }
  std::size_t driven(const std::string& name) {
    const std::size_t n = net(name);
    if (is_driven_[n]) fail(fmt::format("net {}: two things drive it", name));
    is_driven_[n] = true;
    return n;
  }

  void read_line(const std::string& line) {
    std::vector<std::string> words = words_in(line);
    if (words.empty()) return;
    const std::string first = words.front();
    if (first[0] != '.') return read_row(words);
    words.erase(words.begin());
    if (first == ".model") {
      if (!words.empty()) cells_.name = words.front();
    } else if (first == ".inputs") {
      for (const std::string& name : words) cells_.inputs.push_back(driven(name));
    } else if (first == ".outputs") {
      for (const std::string& name : words) cells_.outputs.push_back(net(name));
    } else if (first == ".names") {
      begin_table(words);
    } else if (first != ".end") {
      fail(fmt::format("{}: not a netlist of tables", line));
    }
  }

  void begin_table(const std::vector<std::string>& words) {
    if (words.empty()) fail(".names of nothing");
    if (words.size() > kMostInputs + 1) {
      fail(fmt::format("net {}: a table of {} inputs, more than {}", words.back(), words.size() - 1,
                       kMostInputs));
    }
    Cells::Table table;
    for (std::size_t i = 0; i + 1 < words.size(); ++i) table.of.push_back(net(words[i]));
    table.gives = driven(words.back());
    cells_.tables.push_back(table);
    output_.reset();
  }

  // A row of a cover: what the inputs are, and what the table gives then; all rows give the same.
  void read_row(std::vector<std::string> words) {
    if (cells_.tables.empty()) fail(words.front() + ": not in a table");
    Cells::Table& t = cells_.tables.back();
    if (t.of.empty()) words.insert(words.begin(), "");
    const bool fits = words.size() == 2 && words[0].size() == t.of.size() &&
                      words[0].find_first_not_of("01-") == std::string::npos &&
                      (words[1] == "0" || words[1] == "1");
    if (!fits || (output_ && *output_ != words[1][0])) fail("not a row of this table");
    const std::uint64_t all = ~std::uint64_t{0} >> (64 - (std::size_t{1} << t.of.size()));
    if (!output_ && words[1] == "0") t.table = all;  // the rows say where it is 0
    output_ = words[1][0];
    std::uint64_t rows = 0;
    for (std::size_t i = 0; i < std::size_t{1} << t.of.size(); ++i) {
      bool matches = true;
      for (std::size_t b = 0; b < t.of.size(); ++b) {
        matches = matches && (words[0][b] == '-' || (words[0][b] == '1') == ((i >> b & 1) != 0));
      }
      rows |= std::uint64_t{matches} << i;
    }
    t.table = *output_ == '1' ? t.table | rows : t.table & ~rows;
  }

  void require_drivers() const {
    for (std::size_t n = 0; n < is_driven_.size(); ++n) {
      if (!is_driven_[n]) {
        throw InputError(fmt::format("{}: net {}: nothing drives it", what_, cells_.nets[n]));
      }
    }
  }

  // Each table behind those that it reads.
  void in_order() {
    std::map<std::size_t, std::size_t> giver;  // the table that gives a net
    for (std::size_t i = 0; i < cells_.tables.size(); ++i) giver[cells_.tables[i].gives] = i;
    enum class Seen : char { no, begun, done };
    std::vector<Seen> seen(cells_.tables.size());
    std::vector<Cells::Table> ordered;
    const std::function<void(std::size_t)> place = [&](std::size_t i) {
      const Cells::Table& table = cells_.tables[i];
      if (seen[i] == Seen::done) return;
      if (seen[i] == Seen::begun) {
        throw InputError(fmt::format("{}: net {}: a loop", what_, cells_.nets[table.gives]));
      }
      seen[i] = Seen::begun;
      for (const std::size_t net : table.of) {
        if (const auto from = giver.find(net); from != giver.end()) place(from->second);
      }
      seen[i] = Seen::done;
      ordered.push_back(table);
    };
    for (std::size_t i = 0; i < seen.size(); ++i) place(i);
    cells_.tables = std::move(ordered);
  }

  const std::string& what_;
  Cells cells_;
  std::unordered_map<std::string, std::size_t> numbers_;
  std::vector<bool> is_driven_;
  std::size_t number_ = 0;
  std::optional<char> output_;  // of the table's first row
};

}  // namespace

Cells read_blif(std::string_view text, const std::string& what) { return Reader(what).read(text); }

}  // namespace cosim::nets
