// What a front end reads in another way than Verilog says, without a word. Where it is seen in the
// text it is refused or written otherwise: a simulation finds it only if it happens there.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "tb/equiv/side.h"
#include "tb/equiv/sources.h"

namespace cosim::equiv {

/// InputError "FILE:LINE: ...".
void refuse_misread(const std::vector<SourceText>& sources, FrontEnd front_end);

/// The same of functions and tasks: always @* and assign wait for what their own text reads, and
/// not for what a function reads besides, and gates do; a function that writes a signal is called
/// only where && and the like come to it. A part of the former.
void refuse_routines(const SourceText& source);
void refuse_wide_indices(const SourceText& source);
/// The indices that stand behind a name, which ends at `at`, each without its brackets.
std::vector<std::string> indices_at(std::string_view plain, std::size_t at);
/// The same of assertions and system tasks that assign, count or call what does. A part of the
/// first one.
void refuse_acting_statements(const SourceText& source);
/// The same of a variable that a block assigns by = and by <=, or by <= with other delays. A part
/// of the first one.
void refuse_mixed_assignments(const SourceText& source);

/// What yosys has `said` of expressions on ports that are wider: one line, with the place of the
/// first that it reads in too few bits; "" where there is none.
std::string cut_on_a_port(const std::string& said, const std::vector<SourceText>& sources);
/// Whether there may be such a port; Icarus Verilog reads it as yosys does.
bool may_be_cut_on_ports(const std::vector<SourceText>& sources);

/// Behind a statement that begins at `at` of a blanked text (lexer.h), begin and end included; with
/// the `else` of an `if`, where asked for.
std::size_t behind_statement(std::string_view plain, std::size_t at, bool with_else = false);

/// The text without the comments translate_off and translate_on: yosys leaves out what is between
/// them, and Verilog does not.
std::string without_pragmas(const std::string& text);
/// Whether what is between them is of simulation alone, as far as one can see.
bool hides_simulation(const std::string& text);
/// The text, where it asks for the macro YOSYS, which yosys alone has, without that, on the same
/// lines.
std::string without_macro_of_yosys(const std::string& text);
/// The text without that macro, without such comments where they hide more than simulation, and
/// with asynchronous resets that are asked alone (front_end.h).
std::string revealed(const std::string& text);

/// Whether Icarus Verilog 11 may take a word for another one, as yosys does: in an array of several
/// dimensions an index beyond its own one leads to the next row. So where one behind the first
/// is no constant.
bool has_rows(const std::vector<SourceText>& sources);

}  // namespace cosim::equiv
