// Which G and M codes the reader takes, and which modal group each belongs to.
#pragma once

#include <cstdint>
#include <string>

namespace cosim::toolpath {

/// The modal groups of RS274; two codes of one group may not stand in one block. G80 has one of its
/// own: no canned cycle is ever on, so it ends none, and leaves G0 to G3 as they are. Codes that
/// end what is never on (`cancel`) may stand together and are not kept.
enum class Group : std::uint8_t {
  motion,         ///< G0 G1 G2 G3
  canned_cycle,   ///< G80
  plane,          ///< G17
  units,          ///< G20 G21, and G70 G71 as Mach3 and Siemens have them
  distance,       ///< G90 G91
  arc_distance,   ///< G91.1
  compensation,   ///< G40
  length_offset,  ///< G43 G44 G49
  coordinates,    ///< G54
  path_control,   ///< G61 G61.1 G64
  feed_mode,      ///< G93 G94 G95
  spindle_mode,   ///< G96 G97
  retract,        ///< G98 G99
  look_ahead,     ///< G5 G5.1 G8 G103 G187; G8 is also the lathe's radius mode, the default
  polar,          ///< G15
  scaling,        ///< G50
  mirroring,      ///< G50.1
  non_modal,      ///< G4 G9 G10 G28 G30 G52 G53 G92 G92.1 G92.2
  cancel,         ///< G13.1 G40.1 G67 G69
};
inline constexpr int group_count = 19;

/// A G code that is taken, some beside certain words only: conditions.h, gcode.h. `tenths` is ten
/// times its number: 911 for G91.1.
struct GCode {
  int tenths = 0;
  Group group = Group::motion;
};

/// True with `code` set where the G code of this number is taken; otherwise false with `why` set to
/// a phrase for the person: "G18 is not supported: only ...", "G123 is not a known code".
bool find_g_code(double number, GCode& code, std::string& why);

/// Any whole number from 0 to 999 is taken, as M codes belong to the machine, save those that
/// repeat or call programs or restore modes (M47, M70 to M73, M96 to M99, M198): then false with
/// `why` set.
bool accept_m_code(double number, std::string& why);

/// "G91.1" for 'G' and 911.
std::string code_name(char letter, int tenths);

/// True for M codes that Marlin alone has, or that carry a message: a word X beside them is that
/// control's argument, and another's move (M92, M117, M118, M200 and above).
bool takes_arguments(double m_number);

/// True for M2 and M30.
bool ends_program(double m_number);

}  // namespace cosim::toolpath
