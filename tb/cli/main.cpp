#include <fcntl.h>
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <system_error>

#include "model/core/input_error.h"
#include "tb/cli/command.h"
#include "tb/cli/usage_error.h"
#include "tb/cli/words.h"
#include "tb/leftover.h"

namespace {

constexpr int bad_input = 2;
constexpr const char* no_output = "cannot write to standard output";

int refuse(const std::string& line) {
  cosim::cli::complain(line);
  return bad_input;
}

// A closed stream's number would go to the next file opened, and the text into that file. Opened
// the wrong way round it fails as a closed one does.
void hold_standard_streams() {
  for (int stream = 0; stream <= 2; ++stream) {
    if (fcntl(stream, F_GETFD) == -1) open("/dev/null", stream == 0 ? O_WRONLY : O_RDONLY);
  }
}

int run(int argc, char** argv) {
  CLI::App app{
      "Runs a digital interpolator in Verilog beside its golden model, and compares every\n"
      "register and output on every clock.",
      "cosim"};
  app.require_subcommand(1);
  app.get_formatter()->column_width(24);
  app.footer(
      "Exit status: 0 match, 1 mismatch, 2 bad input.\n"
      "cosim COMMAND --help tells of a command's options.");
  cosim::cli::Action action;
  cosim::cli::add_list(app, action);
  cosim::cli::add_line(app, action);
  cosim::cli::add_arc(app, action);
  cosim::cli::add_dda(app, action);
  cosim::cli::add_path(app, action);
  cosim::cli::add_compare(app, action);
  cosim::cli::add_sweep(app, action);
  cosim::cli::add_replay(app, action);
  cosim::cli::add_prove(app, action);
  if (argc < 2) fmt::print("{}", app.help());
  if (const std::string line = cosim::cli::empty_value(argc, argv); !line.empty()) {
    return refuse(line);
  }
  try {
    app.parse(argc, argv);
    return action();
  } catch (const CLI::CallForHelp& help) {
    return app.exit(help);
  } catch (const CLI::ParseError& error) {
    return refuse(cosim::cli::usage_error(app, error));
  }
}

}  // namespace

int main(int argc, char** argv) {
  hold_standard_streams();
  cosim::remove_leftovers_on_signals();
  int status = bad_input;
  try {
    status = run(argc, argv);
  } catch (const cosim::InputError& error) {
    status = refuse(error.what());
  } catch (const std::bad_alloc&) {
    status = refuse("not enough memory");
  } catch (const std::system_error& error) {  // of a write to standard output, or of a thread
    status = refuse(std::ferror(stdout) == 0 ? error.code().message() : no_output);
  } catch (const std::exception& error) {
    status = refuse(std::string("internal error: ") + error.what());
  }
  if (status != bad_input && (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)) {
    return refuse(no_output);
  }
  return status;
}
