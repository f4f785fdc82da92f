#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <string>

#include "model/core/input_error.h"
#include "tb/cli/command.h"

namespace {

constexpr int bad_input = 2;

int refuse(const std::string& line) {
  std::fflush(stdout);
  fmt::print(stderr, "cosim: {}\n", line);
  return bad_input;
}

// What CLI11 has to say takes several lines; the first says it all.
std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Runs a digital interpolator in Verilog beside its golden model, and compares every\n"
               "register and output on every clock. Exit status: 0 match, 1 mismatch, 2 bad input.",
               "cosim"};
  app.require_subcommand(1);
  app.get_formatter()->column_width(24);
  cosim::cli::Action action;
  cosim::cli::add_list(app, action);
  cosim::cli::add_line(app, action);
  cosim::cli::add_arc(app, action);
  cosim::cli::add_path(app, action);
  cosim::cli::add_sweep(app, action);
  try {
    app.parse(argc, argv);
    const int status = action();
    if (std::fflush(stdout) != 0) return refuse("cannot write to standard output");
    return status;
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return refuse(first_line(error.what()));
  } catch (const cosim::InputError& error) {
    return refuse(error.what());
  } catch (const std::bad_alloc&) {
    return refuse("not enough memory");
  } catch (const std::exception& error) {
    return refuse(fmt::format("failed: {}", first_line(error.what())));
  }
}
