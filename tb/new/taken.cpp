#include "tb/new/taken.h"

#include <set>

namespace cosim::cli {
namespace {

bool is_cpp_word(const std::string& name) {
  static const std::set<std::string> all{"alignas",       "alignof",     "and",
                                         "and_eq",        "asm",         "auto",
                                         "bitand",        "bitor",       "bool",
                                         "break",         "case",        "catch",
                                         "char",          "char16_t",    "char32_t",
                                         "char8_t",       "class",       "co_await",
                                         "co_return",     "co_yield",    "compl",
                                         "concept",       "const",       "const_cast",
                                         "consteval",     "constexpr",   "constinit",
                                         "continue",      "decltype",    "default",
                                         "delete",        "do",          "double",
                                         "dynamic_cast",  "else",        "enum",
                                         "explicit",      "export",      "extern",
                                         "false",         "float",       "for",
                                         "friend",        "goto",        "if",
                                         "inline",        "int",         "long",
                                         "mutable",       "namespace",   "new",
                                         "noexcept",      "not",         "not_eq",
                                         "nullptr",       "operator",    "or",
                                         "or_eq",         "private",     "protected",
                                         "public",        "register",    "reinterpret_cast",
                                         "requires",      "return",      "short",
                                         "signed",        "sizeof",      "static",
                                         "static_assert", "static_cast", "struct",
                                         "switch",        "template",    "this",
                                         "thread_local",  "throw",       "true",
                                         "try",           "typedef",     "typeid",
                                         "typename",      "union",       "unsigned",
                                         "using",         "virtual",     "void",
                                         "volatile",      "wchar_t",     "while",
                                         "xor",           "xor_eq"};
  return all.contains(name);
}

// What records (model/core/record.h) and their templates have already, and macros of the C library
// and of GNU compilers.
bool is_of_records(const std::string& name) {
  static const std::set<std::string> all{
      "V",           "p",      "Inputs",     "Outputs",  "State",    "Table",    "Index",
      "size",        "Self",   "members",    "fields",   "trim",     "select",   "index_end",
      "Record",      "Params", "has_arrays", "FIELD",    "Word",     "std",      "cosim",
      "each_member", "Visit",  "EOF",        "NULL",     "BUFSIZ",   "errno",    "assert",
      "stdin",       "stdout", "stderr",     "linux",    "unix",     "i386",     "select_record",
      "Condition",   "Field",  "RAND_MAX",   "CHAR_BIT", "offsetof", "INFINITY", "NAN",
      "SIZE_MAX"};
  const bool is_index = name.starts_with("index_") || name.starts_with("final_index_");
  return is_index || all.contains(name);
}

}  // namespace

bool is_taken(const std::string& name) { return is_cpp_word(name) || is_of_records(name); }

}  // namespace cosim::cli
