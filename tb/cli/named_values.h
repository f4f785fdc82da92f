// Options that are given once for each of several names, as NAME=VALUE.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace cosim::cli {

/// Names and their values, in the order of `words`; the value of a word without '=' is "". The same
/// word twice is one. InputError where a name has two values, and
/// for "=" without one of both.
std::vector<std::pair<std::string, std::string>> named_values(
    const std::string& option, const std::vector<std::string>& words);

/// The same where each word is NAME=VALUE, neither of them empty. InputError "OPTION: ... is not
/// FORM".
std::vector<std::pair<std::string, std::string>> named_values(const std::string& option,
                                                              const std::vector<std::string>& words,
                                                              const char* form);

}  // namespace cosim::cli
