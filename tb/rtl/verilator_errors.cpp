#include "tb/rtl/verilator_errors.h"

#include "tb/rtl/regex.h"

namespace cosim::rtl {
namespace {

struct Meaning {
  std::string error;    ///< regular expression; PLACE is FILE:LINE, the first group
  std::string meaning;  ///< \1 to \9 are groups of it
};

// The order counts: the first that fits is taken.
const Meaning meanings[] = {
    {"PLACE Cannot find file containing module: '([^']+)'",
     "\\1: no file has the module \\2: give a file that models it, or make a blackbox of it, whose "
     "pins become ports: cosim new --blackbox \\2, in CMake BLACKBOXES \\2"},
    {"Error-(NOTIMING|STMTDLY): ([^ ]*/)?([^ /:]+:[0-9]+):",
     "\\3: waits, as a testbench does and no circuit. Only the delay of an assignment (q <= #1 d) "
     "is left out"},
    {"Parameter without (initial|default) value is never given value[^']*'([^']*)'",
     "the parameter \\2 has no value of its own: give it one: cosim new --param \\2=VALUE, in "
     "CMake "
     "SHAPES \"\\2=VALUE\""},
    {"PLACE Unsupported: Member call on object '[A-Z]+ '([^']*)'' which is a",
     "\\1: \\2 has no members: its type may be a parameter of the top: cosim new --param "
     "TYPE=PACKAGE::STRUCT"},
    {"PLACE Cannot find include file: '?([^']*)",
     "\\1: no folder has the header \\2: cosim new --include DIR, in CMake INCLUDE_DIRS DIR"},
    {"PLACE (Package/class '([^']+)' not found|.*[Pp]ackage.* not found: '([^']+)')",
     "\\1: no file has the package \\3\\4: give its file, too"},
    {"PLACE Define or directive not defined: '`([^']+)'",
     "\\1: no file defines the macro \\2: give the file that does, or cosim new --define \\2, in "
     "CMake DEFINES \\2"},
    {"PLACE Unsupported: Interfaced port on top level module",
     "\\1: an interface is a port of the top: cosim writes a module around it whose ports are "
     "signals, if the port names a modport (bus.target p)"},
    {"PLACE Unsupported in C: Variable has same name as instance: '([^']+)'",
     "\\1: \\2 is the name of a signal and of its module, which Verilator cannot simulate: rename "
     "one"},
    {"Verilator internal fault", "Verilator ends with a fault of its own, and names no line"},
};

}  // namespace

std::string error_in(const std::string& text, const std::string& otherwise) {
  static const Regex first("%Error[^\n]*"), place("PLACE");
  const Match found = first.find(text);
  const std::string error = found ? found[0] : text.substr(0, text.find('\n'));
  for (const Meaning& one : meanings) {
    const Regex known(place.replaced(one.error, "([^ /:]+:[0-9]+):[0-9]+:"));
    if (const Match m = known.find(error)) return known.replaced(m[0], one.meaning);
  }
  return otherwise + ": " + error;
}

}  // namespace cosim::rtl
