// Which G and M codes the reader takes, and which modal group each belongs to.
#pragma once

#include <cstdint>
#include <string>

namespace cosim::toolpath {

/// The modal groups of RS274; two codes of one group may not stand in one block. G80 has one of its
/// own: no canned cycle is ever on, so it ends none, and leaves G0 to G3 as they are.
enum class Group : std::uint8_t {
  motion,         ///< G0 G1 G2 G3
  canned_cycle,   ///< G80
  plane,          ///< G17
  units,          ///< G20 G21
  distance,       ///< G90 G91
  arc_distance,   ///< G91.1
  compensation,   ///< G40
  length_offset,  ///< G43 G49
  coordinates,    ///< G54
  path_control,   ///< G61 G61.1 G64
  feed_mode,      ///< G93 G94 G95
  spindle_mode,   ///< G96 G97
  retract,        ///< G98 G99
  non_modal,      ///< G4 G9
};
inline constexpr int group_count = 14;

/// A G code that is taken. `tenths` is ten times its number: 911 for G91.1.
struct GCode {
  int tenths = 0;
  Group group = Group::motion;
};

/// True with `code` set where the G code of this number is taken; otherwise false with `why` set to
/// a phrase for the person: "G28 is not supported: it ...", "G123 is not a known code".
bool find_g_code(double number, GCode& code, std::string& why);

/// Any whole number from 0 to 999 is taken, as M codes belong to the machine, save those that
/// repeat or call programs or restore modes (M47, M70 to M73, M97 to M99): then false with `why`
/// set.
bool accept_m_code(double number, std::string& why);

/// True for M2 and M30.
bool ends_program(double m_number);

}  // namespace cosim::toolpath
