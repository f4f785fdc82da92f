#include "tb/equiv/yosys_messages.h"

namespace cosim::equiv {

const std::vector<Rule>& yosys_rules() {
  const auto rule = [](const char* pattern, const char* text) {
    return Rule{Pattern(pattern), text};
  };
  static const std::vector<Rule> rules{
      // The hierarchy.
      rule(
          "Module (\\S+) referenced in module (\\S+) in cell (\\S+) is not part of the design\\.",
          "no file has the module $1, of which $2 has the instance $3. Give a file that has it, or "
          "--blackbox $1"),
      rule("Module (\\S+) referenced in module (\\S+) in cell (\\S+) does not have a port named "
           "'?([^']+)'?\\.",
           "module $1 has no port $4, which its instance $3 in $2 connects"),
      rule("Module (\\S+) referenced in module (\\S+) in cell (\\S+) does not have a parameter "
           "named "
           "'?([^']+)'?\\.",
           "module $1 has no parameter $4, which its instance $3 in $2 gives"),
      rule("Module (\\S+) referenced in module (\\S+) in cell (\\S+) has only (\\d+) ports?, "
           "requested port (\\d+)\\.",
           "module $1 has $4 ports, and its instance $3 in $2 connects a port $5"),
      rule("Module (\\S+) not found!", "no file has the module $1"),
      rule("Re-definition of module ([^\\s!]+)!?", "module $1 is there twice"),
      rule("Can't find object for defparam \\$(\\d+)!",
           "an instance gives parameter number $1 in order, and its module has not so many, or a "
           "defparam gives one of them besides"),
      rule("Can't find object for defparam (\\S+)!", "a parameter is given that no module has: $1"),
      rule("Array cell (\\S+) has invalid port vs\\. signal size for port (\\S+?)\\.",
           "an array of instances, $1: port $2 has a width that does not go with its signal's"),
      rule("Unsupported cell type:? (\\$\\w+) .*", "yosys makes no gates of $1"),
      rule("Unsupported cell type:? (\\S+) \\((\\S+)\\)",
           "instance $2: of module $1 no gates can be made"),
      rule("Cyclic dependency between modules found! Cycle includes module (\\S+)\\.",
           "module $1 has itself in it"),
      rule("Cannot (?:flatten a design containing recursive instantiations"
           "|handle recursive module instantiations)\\.",
           "a module has itself in it"),
      // always
      rule("Multiple edge sensitive events found for this signal!",
           "{signal}: more than one edge writes it: one clock, and a reset that is asked first, as "
           "in always @(posedge c or posedge r) if (r) ... else ..."),
      rule("Event with any-edge sensitivity found for this signal!",
           "{signal}: an event without posedge or negedge writes it beside an edge"),
      rule("Async reset (\\S+) yields non-constant value .* for signal (\\S+?)\\.",
           "register $2: where $1 resets it has no constant value"),
      rule("Async reset (\\S+) yields endless loop at value .* for signal (\\S+?)\\.",
           "register $2: where $1 resets its value follows from itself"),
      rule("Async reset (\\S+) causes memory write to (\\S+?)\\.",
           "memory $2: it is written where $1 resets"),
      rule("Async reset value .* is not constant!",
           "{signal}: its asynchronous reset {reset}gives it no constant value"),
      rule("Found non edge/level sensitive event in always_ff process .*",
           "always_ff: needs posedge or negedge"),
      rule("Found non-event list in .*", "always_ff: needs posedge or negedge"),
      rule("Found non-synthesizable event list!",
           "an event list has edges beside signals without posedge or negedge"),
      rule("Found posedge/negedge event on a signal that is not 1 bit wide!",
           "posedge or negedge of a signal of several bits"),
      rule("(?:Latch inferred|Inferred latch) for signal (?:[^ .]+\\.)?(\\S+) from (\\w+) process "
           ".*",
           "$1: a latch, for there is a way through $2 that does not write it"),
      // Words that are not known.
      rule("Can't resolve (?:function|task) name (\\$\\S+?)\\.", "$1 is not supported"),
      rule("Can't resolve task name (wait|cover|assert|assume|restrict)\\.",
           "$1 is not supported here"),
      rule("Can't resolve (function|task) name (\\S+?)\\.", "there is no $1 $2"),
      rule("System task (\\S+) executed\\.", "$1 in an initial block ends it"),
      rule("Identifier (\\S+) is implicitly declared and `default_nettype is set to none\\.",
           "$1 is not declared"),
      rule("Incompatible re-declaration of wire (\\S+?)\\.",
           "$1 is declared twice, not in the same way"),
      rule("Cannot add (\\w+) (\\S+) because a \\w+ with the same name was already created at "
           "(\\S+?):(\\d+)\\.\\S*!",
           "$2 is there twice, first at $3:$4"),
      rule("Module port (\\S+) is not declared in module header\\.",
           "$1 is declared as a port and is not in the module's list of ports"),
      rule("Module port (\\S+) is neither input nor output\\.",
           "port $1 is declared as neither input nor output"),
      rule("Parameter defaults can only be omitted in SystemVerilog mode!",
           "a parameter without a default value, as in SystemVerilog (a file .sv)"),
      rule("Parameter (\\S+) has no default value and has not been overridden!?",
           "parameter $1 has no value of its own: --param $1=VALUE gives it one"),
      rule("(.*) is only supported in SystemVerilog mode\\.", "$1: only in a file .sv"),
      // The preprocessor.
      rule("Found `(\\w+) outside of macro conditional branch!", "`$1 without an `ifdef before it"),
      rule("Unterminated preprocessor conditional!", "an `ifdef without an `endif"),
      rule("Can't open include file (\\S+?)!",
           "`include finds no file $1: --include DIR names its folder"),
      rule("Unimplemented compiler directive or undefined macro "
           "`?(begin_keywords|end_keywords|pragma|unconnected_drive|nounconnected_drive|__LINE__|"
           "__FILE__)\\.",
           "`$1 is not known to yosys"),
      rule("Unimplemented compiler directive or undefined macro `?(\\w+)\\.",
           "`$1 is not defined: --define $1=VALUE, or a file with it"),
      rule(
          "Cannot expand macro `?(\\w+) by giving only (\\d+) arguments? \\(argument (\\d+) has no "
          "default\\)\\.",
          "macro `$1 is given $2 of its arguments, and number $3 has no default"),
      // Constants.
      rule("Digit larger than \\d+ used in in base-(\\d+) constant\\.",
           "a number to base $1 has a digit that is too large"),
      rule("Invalid use of \\[a-fxz\\?\\] in decimal constant\\.",
           "a decimal number has a digit that is none"),
      rule("(?:2nd expression of|Right hand side of 1st expression of|Left hand side of 1st "
           "expression of) (generate|procedural) for-loop is not (?:constant|a genvar)!",
           "a for loop ($1): how often it runs is not constant, or it counts with what is no "
           "genvar"),
      rule("While loops are only allowed in constant functions!",
           "a while loop: how often it runs is not constant"),
      rule("Repeat loops outside must have constant repeat counts!",
           "a repeat loop: how often it runs is not constant"),
      rule("Left operand of replicate expression is not constant!",
           "a replication {N{...}}: N is not constant"),
      rule("Condition for generate (if|case) is not constant!",
           "generate $1: what it depends on is not constant"),
      rule("Non-constant function call in constant expression\\.",
           "a constant is made with a function of what is not constant"),
      rule("(Attribute|Parameter) (\\S+) with non-constant value[!.]",
           "$1 $2: its value is not constant"),
      rule("Memory (\\S+) with non-constant width or size!",
           "memory $1: its width or size is not constant"),
      rule("Failed to detect width (?:of \\w+ access|for identifier|for parameter|of) (\\S+?)!",
           "$1: its range is not constant"),
      rule("Failed to evaluate system function (\\S+) with (.*)\\.", "$1 of a $2"),
      // Memories.
      rule("Identifier (\\S+) does map to an unexpanded memory!",
           "$1 is a memory: only words of it can be read, or written"),
      rule("Invalid array access\\.", "a memory is used as a whole, or with too many indices"),
      rule("Can not open file (\\S+) for (\\$\\w+)\\.", "$2: there is no file $1"),
      rule("Failed to get a constant init value for (\\S+?): .*",
           "$1: its initial value is computed from other variables, which yosys does not do"),
      rule("Conflicting initialization values for (\\S+?)\\.?",
           "$1 has two initial values, one where it is declared and one in an initial block"),
      rule("found logic loop in module (\\S+):", "a combinational loop in module $1"),
      rule("Design contains 'x' or 'z' bits\\..*", "a bit is x or z, of which no gate is made"),
      // Checks of yosys's own.
      rule("Assert `new_cell->children\\.at\\(0\\)->type == AST_CELLTYPE' failed.*",
           "an array of gates, as in and g[3:0](...), which yosys does not take"),
      rule("Assert `arg->is_signed == sig\\.as_wire\\(\\)->is_signed' failed.*",
           "a port is given an expression whose sign is not that of its parts: put it in a wire"),
      rule("Assert .* failed.*", "yosys does not take it, and does not say what"),
      rule("Abort.*", "yosys does not take it, and does not say what")};
  return rules;
}

}  // namespace cosim::equiv
