#include "tb/sim/stimulus_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>

#include "model/core/input_error.h"
#include "tb/util/read_file.h"
#include "tb/util/show.h"
#include "tb/util/words.h"

namespace cosim {
namespace {

// A little more than the stimulus of any mismatch: 100 MB.
constexpr std::uint64_t most_clocks = 1'100'000;
static_assert(most_clocks > most_kept + Mismatch::clocks_behind);
// More than any machine has inputs.
constexpr std::size_t most_words = 10'000;

// How a number in another form is written: "; write 00004" of 0x4. Empty of what is none.
std::string as_written(const Field& field, std::string_view text) {
  const bool is_hex = text.starts_with("0x") || text.starts_with("0X");
  if (is_hex) text.remove_prefix(2);
  std::uint64_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number, is_hex ? 16 : 10);
  const auto value = static_cast<Word>(number);
  if (error != std::errc() || stop != end || low_bits(value, field.width) != value) return "";
  return "; write " + show_short(field, value);
}

// The words before a #, the first `most_words` of them and one more.
std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view blanks = " \t\v\f\r";
  line = line.substr(0, line.find('#'));
  std::vector<std::string_view> words;
  while (words.size() <= most_words) {
    line.remove_prefix(std::min(line.size(), line.find_first_not_of(blanks)));
    if (line.empty()) break;
    words.push_back(line.substr(0, line.find_first_of(blanks)));
    line.remove_prefix(words.back().size());
  }
  return words;
}

std::optional<std::uint64_t> number(std::string_view text) {
  constexpr std::size_t most_digits = 18;
  if (text.empty() || text.size() > most_digits) return {};
  std::uint64_t value = 0;
  const char* end = text.data() + text.size();
  if (std::from_chars(text.data(), end, value).ptr != end) return {};
  return value;
}

std::string printable(std::string_view text) {
  std::string clean(text);
  for (char& c : clean) c = c >= ' ' && c <= '~' ? c : '?';
  return clean;
}

class Parser {
 public:
  Parser(const std::string& name, std::string_view text) : name_(name), left_(text) {
    constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
    if (left_.starts_with(byte_order_mark)) left_.remove_prefix(byte_order_mark.size());
  }

  Replay parse(const std::vector<std::unique_ptr<AnyBench>>& benches) {
    if (!next() || line_ != first_line_of_stimulus) {
      fail(fmt::format("is not '{}'", first_line_of_stimulus));
    }
    machine(benches);
    const std::string row_word = replay_.bench->row();
    const std::string wanted = "a row '" + row_word + "' of the inputs' names";
    while (need_line(wanted.c_str()), words_[0] != row_word) header();
    names();
    while (need_line("'end'"), words_[0] != "end") row();
    if (words_.size() != 1) fail("text after 'end'");
    if (next_words()) fail("text after 'end'");
    if (replay_.stimulus.clocks.empty()) fail(fmt::format("there is no {} in it", row_word));
    return std::move(replay_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}:{}: {}", name_, std::max<std::uint64_t>(at_, 1), what));
  }

  bool next() {
    if (left_.empty()) return false;
    ++at_;
    line_ = left_.substr(0, left_.find('\n'));
    left_.remove_prefix(std::min(left_.size(), line_.size() + 1));
    if (line_.ends_with('\r')) line_.remove_suffix(1);
    return true;
  }
  bool next_words() {
    while (next()) {
      words_ = words_of(line_);
      if (words_.empty()) continue;
      if (words_.size() > most_words && words_[0] != "origin") {
        fail(fmt::format("more than {} words in a line", most_words));
      }
      return true;
    }
    return false;
  }
  void need_line(const char* wanted) {
    if (!next_words()) fail(fmt::format("the file ends before {}: it is not complete", wanted));
  }
  // The text after the line's first word.
  std::string rest() const {
    const std::size_t begin = line_.find(words_[0]) + words_[0].size();
    const std::size_t text = line_.find_first_not_of(" \t", begin);
    return text == std::string_view::npos ? "" : printable(line_.substr(text));
  }

  void machine(const std::vector<std::unique_ptr<AnyBench>>& benches) {
    need_line("'machine'");
    if (words_[0] != "machine") fail("is not 'machine DESIGN PARAMETER=VALUE...'");
    const std::string title = fmt::format("{}", fmt::join(words_.begin() + 1, words_.end(), " "));
    for (const auto& bench : benches) {
      if (bench->title() == title) replay_.bench = bench.get();
    }
    if (replay_.bench == nullptr) {
      fail(fmt::format("no machine {} is built; see {} list", in_quotes(title), program_name()));
    }
    replay_.stimulus.machine = title;
    inputs_ = replay_.bench->inputs();
  }

  void header() {
    Stimulus& s = replay_.stimulus;
    if (words_[0] == "origin") {
      s.origin = rest();
    } else if (words_[0] == "power-up") {
      const auto value = words_.size() == 2 ? number(words_[1]) : std::nullopt;
      if (!value || *value > 0xffffffffU) fail("power-up: needs a number of 0 to 4294967295");
      s.power_up = static_cast<std::uint32_t>(*value);
    } else if (words_[0] == "state") {
      state();
    } else {
      fail(fmt::format("{} is not origin, power-up, state or {}", in_quotes(words_[0]),
                       replay_.bench->row()));
    }
  }

  void state() {
    const std::vector<Field> fields = replay_.bench->state();
    if (!replay_.stimulus.state) replay_.stimulus.state = replay_.bench->reset_state();
    for (std::size_t w = 1; w < words_.size(); ++w) {
      const std::size_t equals = words_[w].find('=');
      if (equals == std::string_view::npos) {
        fail(fmt::format("{} is not NAME=NUMBER", in_quotes(words_[w])));
      }
      const std::string_view name = words_[w].substr(0, equals);
      const auto field =
          std::ranges::find_if(fields, [&](const Field& f) { return label_of(f) == name; });
      if (field == fields.end()) {
        fail(fmt::format("{} has no state {}", replay_.stimulus.machine, in_quotes(name)));
      }
      const auto value = parse_state(*field, words_[w].substr(equals + 1));
      if (!value) fail(fmt::format("{} is out of range or no number", in_quotes(words_[w])));
      (*replay_.stimulus.state)[static_cast<std::size_t>(field - fields.begin())] = *value;
    }
  }

  static std::optional<Word> parse_state(const Field& field, std::string_view text) {
    Word value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end || !is_state(field, value)) return {};
    return value;
  }

  void names() {
    for (std::size_t w = 1; w < words_.size(); ++w) {
      if (std::find(words_.begin() + 1, words_.begin() + static_cast<std::ptrdiff_t>(w),
                    words_[w]) != words_.begin() + static_cast<std::ptrdiff_t>(w)) {
        fail(fmt::format("{} is given twice", in_quotes(words_[w])));
      }
      const auto field =
          std::ranges::find_if(inputs_, [&](const Field& f) { return label_of(f) == words_[w]; });
      if (field == inputs_.end()) {
        fail(fmt::format("{} has no input {}", replay_.stimulus.machine, in_quotes(words_[w])));
      }
      columns_.push_back(static_cast<std::size_t>(field - inputs_.begin()));
    }
    for (std::size_t i = 0; i < inputs_.size(); ++i) {
      if (std::ranges::find(columns_, i) == columns_.end()) {
        fail(fmt::format("input {} has no column", label_of(inputs_[i])));
      }
    }
  }

  // How many clocks the row stands for: "7" one, "7-9" three.
  std::uint64_t repeats() const {
    const std::vector<std::vector<Word>>& clocks = replay_.stimulus.clocks;
    const char* noun = replay_.bench->row();
    const std::size_t dash = words_[0].find('-');
    const auto first = number(words_[0].substr(0, dash));
    const auto last = dash == std::string_view::npos ? first : number(words_[0].substr(dash + 1));
    if (!first || !last || *last < *first) {
      fail(fmt::format("{0} is no {1} and no range of {1}s", in_quotes(words_[0]), noun));
    }
    if (*first != clocks.size()) {
      fail(fmt::format("{0} {1} instead of {0} {2}", noun, *first, clocks.size()));
    }
    if (*last >= most_clocks) fail(fmt::format("more than {} {}s", most_clocks, noun));
    return *last - *first + 1;
  }

  void row() {
    if (words_.size() != columns_.size() + 1) {
      fail(fmt::format("{} for {}", count(words_.size() - 1, "value"),
                       count(columns_.size(), "input")));
    }
    std::vector<Word> values(inputs_.size());
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      const Field& field = inputs_[columns_[c]];
      const auto value = parse_short(field, words_[c + 1]);
      if (!value) {
        fail(fmt::format("{}: {} is no value of {} bit{}{}", label_of(field),
                         in_quotes(words_[c + 1]), field.width, field.width == 1 ? "" : "s",
                         as_written(field, words_[c + 1])));
      }
      values[columns_[c]] = *value;
    }
    replay_.stimulus.clocks.insert(replay_.stimulus.clocks.end(), repeats(), values);
  }

  const std::string& name_;
  std::string_view left_;
  std::uint64_t at_ = 0;
  std::string_view line_;
  std::vector<std::string_view> words_;
  std::vector<Field> inputs_;
  std::vector<std::size_t> columns_;
  Replay replay_;
};

}  // namespace

Replay parse_stimulus(const std::string& name, const std::string& text,
                      const std::vector<std::unique_ptr<AnyBench>>& benches) {
  return Parser(name, text).parse(benches);
}

Replay read_stimulus(const std::string& path,
                     const std::vector<std::unique_ptr<AnyBench>>& benches) {
  return parse_stimulus(path, read_file(path), benches);
}

}  // namespace cosim
