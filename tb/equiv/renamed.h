// Registers that a commit has renamed: those of both RTLs that have no partner by name, as wide as
// each other, that do the same from reset on in a random simulation.
//
// A pair is a guess that a proof has to confirm: a wrong one makes no RTLs equal, for next values
// and initial values of a pair are compared.
#pragma once

#include <map>
#include <string>

#include "tb/equiv/equiv.h"

namespace cosim::equiv {

/// Gives each register of the new RTL the name of the old one that drives a net of the same name.
/// A variable of another width in each, as [31:2] and [31:0], has its bits by their indices in
/// both; one of the same width by their places, so that [31:2] is [29:0].
void name_alike(Side& gold, Side& gate);

/// Gives each register of the new RTL that is one of the old RTL by another name that name.
/// Question::same has those that are known, which come first. Returns all: old names and new ones.
/// InputError where `same` names what is no register, or one of another width.
std::map<std::string, std::string> name_renamed(Question& question);

}  // namespace cosim::equiv
