// What a comparison says of itself: lines for a person, JSON for a program, a page, and the folder
// that a difference leaves.
//
//   report.txt       what was assumed, the verdict, and what came of the replay
//   report.json      the same for a program, with the stimulus
//   report.html      the same as a page, with the wave around the difference
//   stimulus.csv     inputs and outputs of both, a line a clock, up to the difference
//   wave.fst         the clocks around it; wave.gtkw is its view for GTKWave
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "tb/equiv/equiv.h"
#include "tb/show/picture.h"

namespace cosim::equiv {

/// What the result holds for, one line: the reset, what begins as any, and what the question ties
/// and leaves out.
std::string assumed_text(const Question& question);

/// The verdict on `top`, lines.
std::string verdict_text(const std::string& top, const Question& question, const Answer& answer);

/// An object, lines.
std::string result_json(const std::string& top, const Question& question, const Answer& answer);

/// Of what is not different; else the folder has one.
std::string page_of(const std::string& top, const Question& question, const Answer& answer);

/// root/TOP-equiv
std::filesystem::path folder_of(const std::string& top, const std::filesystem::path& root);

struct Kept {
  std::filesystem::path folder;
  std::string page;  ///< report.html
};
/// Writes that folder of what is different; its wave shows `after` clocks behind the difference.
/// InputError where it cannot be written.
Kept keep(const std::string& top, const Question& question, const Answer& answer,
          const std::filesystem::path& root, std::uint64_t after);

/// Draws the clocks around the difference into the file `fst`, with its view, and returns the
/// picture. The hierarchies of both are in it, as old.* and new.*, where Verilator recorded them.
/// A bit that the old RTL leaves x is drawn as the new one has it; a word that is x in all its bits
/// counts as not compared, and so do the clocks of the reset. `after`: clocks behind the
/// difference. InputError where it cannot be written.
WavePicture draw(const Question& question, const Answer& answer, std::uint64_t after,
                 const std::string& fst);

}  // namespace cosim::equiv
