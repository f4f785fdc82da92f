#include "tb/new/liberty.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <string_view>

#include "model/core/input_error.h"
#include "tb/util/words.h"

namespace cosim::cli {
namespace {

class LibertyReader {
 public:
  LibertyReader(std::string_view text, const std::string& file) : text_(text), file_(file) {
    next();
  }

  LibertyGroup read() {
    if (word_ != "library" || is_text_) fail("is no Liberty file: it does not begin with library");
    LibertyGroup all;
    statement(all);
    if (all.groups.empty()) fail("the library has no group");
    return all.groups.front();
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}:{}: {}", file_, line_, what));
  }

  void skip() {
    const auto starts = [&](std::string_view with) { return text_.substr(at_).starts_with(with); };
    const auto go_to = [&](std::string_view end) {
      const std::size_t stop = std::min(text_.find(end, at_ + 2), text_.size());
      line_ += std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_),
                          text_.begin() + static_cast<std::ptrdiff_t>(stop), '\n');
      at_ = std::min(stop + (end == "\n" ? 0 : end.size()), text_.size());
    };
    while (at_ < text_.size()) {
      if (starts("/*")) {
        go_to("*/");
      } else if (starts("//")) {
        go_to("\n");
      } else if (text_[at_] == '\\' || std::isspace(static_cast<unsigned char>(text_[at_])) != 0) {
        line_ += text_[at_++] == '\n' ? 1 : 0;
      } else {
        return;
      }
    }
  }

  // The next word, text in quotation marks, or sign; "" at the end.
  void next() {
    skip();
    is_text_ = false;
    word_.clear();
    if (at_ == text_.size()) return;
    constexpr std::string_view signs = "(){}:;,";
    if (text_[at_] == '"') {
      is_text_ = true;
      for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_) {
        line_ += text_[at_] == '\n' ? 1 : 0;
        if (text_[at_] != '\\' && text_[at_] != '\n') word_ += text_[at_];
      }
      ++at_;
      at_ = std::min(at_, text_.size());
      return;
    }
    do {
      word_ += text_[at_++];
    } while (signs.find(word_.front()) == std::string_view::npos && at_ < text_.size() &&
             signs.find(text_[at_]) == std::string_view::npos && text_[at_] != '"' &&
             std::isspace(static_cast<unsigned char>(text_[at_])) == 0);
  }

  bool is(const char* sign) const { return !is_text_ && word_ == sign; }
  void want(const char* sign) {
    if (!is(sign)) fail(fmt::format("{} instead of {}", in_quotes(word_), sign));
    next();
  }

  // NAME : VALUE;  NAME (VALUES);  NAME (NAMES) { STATEMENTS }
  void statement(LibertyGroup& in) {
    const std::string name = word_;
    next();
    if (is(":")) {
      next();
      std::string value;
      for (; !is(";") && !is("}") && !word_.empty(); next()) {
        value += (value.empty() ? "" : " ") + word_;
      }
      in.attributes.push_back({name, value});
      if (is(";")) next();
      return;
    }
    want("(");
    LibertyGroup group{name, {}, {}, {}};
    for (; !is(")"); next()) {
      if (word_.empty() && !is_text_) fail("the file is incomplete");
      if (!is(",")) group.names.push_back(word_);
    }
    next();
    if (!is("{")) {
      if (name == "include_file") fail("include_file is not read: give that file too");
      if (is(";")) next();
      return;
    }
    constexpr int most = 50;
    if (++depth_ > most) fail("groups are nested too deep");
    for (next(); !is("}");) {
      if (word_.empty() && !is_text_) fail("the file is incomplete");
      if (is(";")) {
        next();
      } else {
        statement(group);
      }
    }
    --depth_;
    next();
    if (is(";")) next();
    in.groups.push_back(std::move(group));
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
  std::ptrdiff_t line_ = 1;
  std::string word_;
  bool is_text_ = false;
  int depth_ = 0;
};

}  // namespace

std::string LibertyGroup::value(const std::string& attribute) const {
  const auto at = std::ranges::find(attributes, attribute, &Attribute::name);
  return at == attributes.end() ? "" : at->value;
}

LibertyGroup read_liberty(const std::string& text, const std::string& file) {
  return LibertyReader(text, file).read();
}

}  // namespace cosim::cli
