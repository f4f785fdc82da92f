#include "model/toolpath/codes.h"

#include <cmath>

namespace cosim::toolpath {

namespace {

constexpr GCode accepted[] = {
    {0, Group::motion},          {10, Group::motion},         {20, Group::motion},
    {30, Group::motion},         {800, Group::canned_cycle},  {170, Group::plane},
    {200, Group::units},         {210, Group::units},         {900, Group::distance},
    {910, Group::distance},      {911, Group::arc_distance},  {400, Group::compensation},
    {430, Group::length_offset}, {490, Group::length_offset}, {540, Group::coordinates},
    {610, Group::path_control},  {611, Group::path_control},  {640, Group::path_control},
    {930, Group::feed_mode},     {940, Group::feed_mode},     {950, Group::feed_mode},
    {960, Group::spindle_mode},  {970, Group::spindle_mode},  {980, Group::retract},
    {990, Group::retract},       {40, Group::non_modal},      {90, Group::non_modal},
};

struct Refused {
  int first;  ///< tenths
  int last;
  const char* why;
};

constexpr Refused refused[] = {
    {50, 53, "splines are not drawn"},
    {70, 80, "lathe modes would change the path"},
    {100, 100, "it sets offsets that would change the path"},
    {120, 139, "pockets are not drawn"},
    {160, 160, "polar coordinates would change the path"},
    {180, 199, "only the XY plane, G17, is drawn"},
    {280, 309, "moves to stored positions are not drawn"},
    {310, 319, "probing moves are not drawn"},
    {330, 339, "synchronised moves are not drawn"},
    {380, 389, "probing moves are not drawn"},
    {410, 429, "cutter compensation would change the path"},
    {431, 439, "its axis words would be offsets, not moves"},
    {510, 519, "scaling and mirroring would change the path"},
    {520, 520, "coordinate offsets would change the path"},
    {530, 530, "moves in machine coordinates are not drawn"},
    {550, 599, "only the coordinate system G54 is drawn"},
    {650, 679, "macros are not run"},
    {680, 689, "rotation would change the path"},
    {730, 769, "canned cycles are not drawn"},
    {810, 899, "canned cycles are not drawn"},
    {901, 901, "arc centres are incremental, G91.1"},
    {920, 929, "coordinate offsets would change the path"},
};

// Ten times the number where that is a whole number that a code can have, else -1.
int tenths_of(double number) {
  const double tenths = number * 10;
  if (!(tenths >= 0 && tenths < 10000)) return -1;
  const double whole = std::round(tenths);
  return std::abs(tenths - whole) < 1e-6 ? static_cast<int>(whole) : -1;
}

std::string code_name(char letter, int tenths) {
  std::string name = letter + std::to_string(tenths / 10);
  if (tenths % 10 != 0) name += "." + std::to_string(tenths % 10);
  return name;
}

}  // namespace

bool find_g_code(double number, GCode& code, std::string& why) {
  const int tenths = tenths_of(number);
  for (const GCode& known : accepted) {
    if (known.tenths != tenths) continue;
    code = known;
    return true;
  }
  why = tenths < 0 ? "this is not a known G code" : code_name('G', tenths) + " is not a known code";
  for (const Refused& range : refused) {
    if (tenths < range.first || tenths > range.last) continue;
    why = code_name('G', tenths) + " is not supported: " + range.why;
  }
  return false;
}

bool accept_m_code(double number, std::string& why) {
  const int tenths = tenths_of(number);
  if (tenths < 0 || tenths % 10 != 0) {
    why = "this is not a known M code";
    return false;
  }
  const int code = tenths / 10;
  if (code == 47 || (code >= 97 && code <= 99)) {
    why = code_name('M', tenths) + " is not supported: repeats and subprograms are not run";
    return false;
  }
  if (code >= 70 && code <= 73) {
    why = code_name('M', tenths) + " is not supported: saved modes are not restored";
    return false;
  }
  return true;
}

bool ends_program(double m_number) { return m_number == 2 || m_number == 30; }

}  // namespace cosim::toolpath
