// Runs the program and takes down what it says.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tests/support/folder.h"
#include "tests/support/has.h"

namespace cosim::cli {

namespace fs = std::filesystem;
using test::expect_has, test::Folder, test::has, test::InAFolder;
using Arguments = std::vector<std::string>;

/// The words of `first` with `more` behind them.
inline Arguments joined(Arguments first, const Arguments& more) {
  first.insert(first.end(), more.begin(), more.end());
  return first;
}

/// How a run ended. A status of 128 + n is a death by signal n.
struct Ended {
  int status = -1;
  std::string out;
  std::string err;
  long peak = 0;  ///< of memory, in bytes; that of this test included, where it holds more
};

/// A run, which has to end with that status.
Ended ends(int status, Ended ended, const char* file = __builtin_FILE(),
           int line = __builtin_LINE());

/// What a run says that is refused, which is one line.
std::string refusal(const Ended& ended, const char* file = __builtin_FILE(),
                    int line = __builtin_LINE());

/// Where standard output goes: into Ended::out, to the file of that path (opened as a shell's >
/// does), or nowhere, closed. The same of standard error.
struct Output {
  std::string path = {};
  bool closed = false;
  std::string err_path = {};
  bool err_closed = false;
};

/// The program as shipped, in its full form, with standard input from /dev/null.
Ended cosim(const Arguments& arguments, const Output& output = {});

/// The program as shipped, killed after so many milliseconds where it has not ended by then:
/// whether it was.
bool cosim_killed(const Arguments& arguments, int after);

/// What a signal waits for: so many milliseconds, or for as long at most until a line is written.
enum class Until { the_time, a_line };

/// The program as shipped, sent `signal` after so many milliseconds.
Ended cosim_signalled(const Arguments& arguments, int signal, int after,
                      Until until = Until::the_time);

/// The same as soon as `ready` says so, after ten minutes, or not at all where it has ended.
Ended cosim_signalled(const Arguments& arguments, int signal, const std::function<bool()>& ready);

/// The same of the faulty program, which is killed where the signal has not ended it in a minute.
Ended faulty_signalled(const Arguments& arguments, int signal, const std::function<bool()>& ready);

/// A copy of the program as shipped that differs from it in a byte, as another build does.
Ended another_build(const Arguments& arguments);

/// Its small form, which becomes the full one.
Ended small_cosim(const Arguments& arguments);

/// The one with faults in its benches (faulty_benches.cpp).
Ended faulty(const Arguments& arguments);

/// The one whose bench is the variant of the RTL that $COSIM_VARIANT names (variant_benches.cpp).
Ended variant(const Arguments& arguments);

/// Whether this system gives a test a terminal; a bare chroot does not.
bool has_terminals();

/// The program on a terminal of so many columns. Ended::out is all that the terminal was sent.
Ended cosim_on_terminal(const Arguments& arguments, unsigned short columns);

/// The lines of a text without their '\n'. A text not ended by one has a last line all the same.
std::vector<std::string> lines(const std::string& text);

}  // namespace cosim::cli
