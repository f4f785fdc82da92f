// Names and sizes in C++, of those in RTL that was read.
#include <fmt/core.h>

#include <algorithm>
#include <cctype>

#include "tb/new/new.h"
#include "tb/util/words.h"

namespace cosim::cli {

int part_of(const FoundNet& memory) {
  constexpr int widest = 64;
  int part = std::min(memory.width.number, widest);
  while (memory.width.number % part != 0) --part;
  return part;
}

std::string text_of(const FoundSize& size,
                    const std::function<std::string(const std::string&)>& name) {
  if (size.text.empty()) return std::to_string(size.number);
  std::string text;
  for (std::size_t at = 0; at < size.text.size(); ++at) {
    if (size.text[at] != '{') {
      text += size.text[at];
      continue;
    }
    const std::size_t end = size.text.find('}', at);
    text += name(size.text.substr(at + 1, end - at - 1));
    at = end;
  }
  return text;
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

std::string in_one_word(const std::string& name) {
  std::string word;
  for (const std::string& part : parts_in(name, '_')) {
    if (!part.empty()) word += upper(part.substr(0, 1)) + part.substr(1);
  }
  return word;
}

TakenNames::TakenNames(const std::string& more) {
  static constexpr const char* cpp =
      "alignas alignof and and_eq asm auto bitand bitor bool break case catch char char16_t "
      "char32_t char8_t class co_await co_return co_yield compl concept const const_cast "
      "consteval constexpr constinit continue decltype default delete do double dynamic_cast "
      "else enum explicit export extern false float for friend goto if inline int long mutable "
      "namespace new noexcept not not_eq nullptr operator or or_eq private protected public "
      "register reinterpret_cast requires return short signed sizeof static static_assert "
      "static_cast struct switch template this thread_local throw true try typedef typeid "
      "typename union unsigned using virtual void volatile wchar_t while xor xor_eq";
  static constexpr const char* macros =
      "EOF NULL BUFSIZ errno assert stdin stdout stderr linux unix i386 RAND_MAX CHAR_BIT "
      "offsetof INFINITY NAN SIZE_MAX";
  const auto words = words_in(fmt::format("std cosim {} {} {}", cpp, macros, more));
  all_.insert(words.begin(), words.end());
}

std::string TakenNames::other_than(const std::string& path) const {
  std::string name;
  bool joins = false;  // "store[3].tag" is store_3_tag
  for (const char c : path) {
    if (c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0) {
      if (joins) name += '_';
      name += c;
      joins = false;
    } else {
      joins = true;
    }
  }
  if (std::isdigit(static_cast<unsigned char>(name.front())) != 0) name = '_' + name;
  while (contains(name)) name += '_';
  return name;
}

}  // namespace cosim::cli
