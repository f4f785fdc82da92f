// What is wrong with a command line, in one line of our own.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace cosim::cli {

/// The line for an error that `app` has thrown from its parsing.
std::string usage_error(const CLI::App& app, const CLI::ParseError& error);

/// The line for an argument such as `--csv=`, whose value CLI11 would take from the next argument;
/// empty where there is none.
std::string empty_value(int argc, const char* const* argv);

}  // namespace cosim::cli
