// Numbers as a person types them, with an error that names the option and the range.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/circular/arc.h"

namespace cosim::cli {

/// A whole number from `low` to `high`, in decimal digits alone. InputError "--name: ..."
/// otherwise.
std::uint64_t whole(const std::string& name, const std::string& text, std::uint64_t low,
                    std::uint64_t high);

/// A whole number of either sign, at most `size` in size. InputError "--name: ..." otherwise.
std::int64_t integer(const std::string& name, const std::string& text, std::int64_t size);

/// Whole numbers of either sign with commas between them: as many as there are `sizes`, each at
/// most so large. `form` is how such a list is written, "X,Y". InputError "--name: ..." otherwise.
std::vector<std::int64_t> integers(const std::string& name, const std::string& text,
                                   const std::string& form, const std::vector<std::int64_t>& sizes);

/// A decimal number above 0 and at most `high`; neither nan nor infinite. InputError otherwise.
double positive(const std::string& name, const std::string& text, double high);

/// "X,Y", each a whole number from 0 to `high`. InputError otherwise.
circular::Point point(const std::string& name, const std::string& text, std::uint64_t high);

}  // namespace cosim::cli
