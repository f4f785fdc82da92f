#include <fcntl.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <system_error>

#include "model/core/input_error.h"
#include "tb/cli/chosen.h"
#include "tb/cli/commands.h"
#include "tb/cli/full.h"
#include "tb/cli/registry.h"
#include "tb/sim/bench.h"
#include "tb/util/interrupt.h"
#include "tb/util/leftover.h"
#include "tb/util/stack.h"
#include "tb/util/words.h"

namespace {

constexpr int bad_input = 2;
constexpr const char* no_output = "cannot write to standard output";

int refuse(const std::string& line) {
  cosim::complain(line);
  return bad_input;
}

// A closed stream's number would go to the next file opened, and the text into that file. Opened
// the wrong way round it fails as a closed one does.
void hold_standard_streams() {
  for (int stream = 0; stream <= 2; ++stream) {
    if (fcntl(stream, F_GETFD) == -1) open("/dev/null", stream == 0 ? O_WRONLY : O_RDONLY);
  }
}

// A design that cannot be used is an error where it is named, or where there is no other.
void check_designs(int argc, char** argv) {
  const bool there_is_another = !cosim::benches().empty();
  for (const cosim::Unusable& design : cosim::unusable()) {
    const bool named = std::find(argv, argv + argc, design.design) != argv + argc;
    if (named || !there_is_another) throw cosim::InputError(design.why);
  }
}

int run(int argc, char** argv) {
  cosim::name_program(cosim::cli::registry().program(), argc > 0 ? argv[0] : "");
  check_designs(argc, argv);
  cosim::cli::form().hand_over(cosim::cli::registry());
  return cosim::cli::run_program(
      argc, argv, cosim::program_name(),
      "Runs a design in Verilog beside its golden model, and compares every register and\n"
      "output on every clock.",
      [](const cosim::cli::Command& program) {
        program.footer("Exit status: 0 match, 1 mismatch, 2 bad input.\n" + cosim::program_name() +
                       " COMMAND --help explains a command and its options.");
        const cosim::cli::Registry& registry = cosim::cli::registry();
        if (cosim::benches().empty()) {  // the program of the package
          cosim::cli::add_wave_command(program);
          return cosim::cli::form().add_commands(program, registry);
        }
        cosim::cli::add_list(program);
        for (const auto& add : registry.commands()) add(program);
        cosim::cli::add_examples(program, registry);
        cosim::cli::add_sweep(program, registry);
        cosim::cli::add_job(program);
        cosim::cli::add_program(program);
        cosim::cli::add_replay(program);
        cosim::cli::add_wave_command(program);
        cosim::cli::add_cover(program, registry);
        cosim::cli::form().add_commands(program, registry);
      });
}

const cosim::cli::Form* chosen_form = nullptr;
char** arguments = nullptr;

}  // namespace

const cosim::cli::Form& cosim::cli::form() { return *chosen_form; }
char** cosim::cli::command_line() { return arguments; }

int cosim::cli::run_form(int argc, char** argv, const Form& form) {
  chosen_form = &form;
  cosim::allow_large_records();
  arguments = argv;
  hold_standard_streams();
  cosim::remove_leftovers_on_signals();
  int status = bad_input;
  try {
    status = ::run(argc, argv);
  } catch (const cosim::Interrupted& interrupted) {
    status = 128 + interrupted.signal;
  } catch (const cosim::InputError& error) {
    status = refuse(error.what());
  } catch (const std::bad_alloc&) {
    status = refuse("not enough memory");
  } catch (const std::system_error& error) {  // of a write to standard output, or of a thread
    status = refuse(std::ferror(stdout) == 0 ? error.code().message() : no_output);
  } catch (const std::exception& error) {
    status = refuse(std::string("internal error: ") + error.what());
  } catch (...) {  // by a model or its check
    status = refuse("internal error: something was thrown that is no std::exception");
  }
  if (status == 0 && cosim::cli::was_left_out()) status = bad_input;
  if (status != bad_input && (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)) {
    return refuse(no_output);
  }
  return status;
}
