// Numbers as a person types them, with an error that names the option and the range.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cosim::cli {

/// A whole number from `low` to `high`, in decimal digits alone. InputError "--name: ..."
/// otherwise.
std::uint64_t whole(const std::string& name, const std::string& text, std::uint64_t low,
                    std::uint64_t high);

/// A range with both ends in it.
struct Range {
  std::int64_t low = 0, high = 0;
};

/// Whole numbers with commas between them: as many as there are `ranges`, each in its own. `form`
/// names them, "X,Y". InputError "--name: ..." otherwise, "--name: X: ..." of one of them.
std::vector<std::int64_t> integers(const std::string& name, const std::string& text,
                                   const std::string& form, const std::vector<Range>& ranges);

/// A decimal number above 0 and at most `high`; neither nan nor infinite. InputError otherwise.
double positive(const std::string& name, const std::string& text, double high);

}  // namespace cosim::cli
