#include "model/toolpath/codes.h"

#include <cmath>

namespace cosim::toolpath {

namespace {

constexpr GCode accepted[] = {
    {0, Group::motion},          {10, Group::motion},         {20, Group::motion},
    {30, Group::motion},         {800, Group::canned_cycle},  {170, Group::plane},
    {200, Group::units},         {210, Group::units},         {700, Group::units},
    {710, Group::units},         {900, Group::distance},      {910, Group::distance},
    {911, Group::arc_distance},  {400, Group::compensation},  {430, Group::length_offset},
    {440, Group::length_offset}, {490, Group::length_offset}, {540, Group::coordinates},
    {610, Group::path_control},  {611, Group::path_control},  {640, Group::path_control},
    {930, Group::feed_mode},     {940, Group::feed_mode},     {950, Group::feed_mode},
    {960, Group::spindle_mode},  {970, Group::spindle_mode},  {980, Group::retract},
    {990, Group::retract},       {50, Group::look_ahead},     {51, Group::look_ahead},
    {80, Group::look_ahead},     {1030, Group::look_ahead},   {1870, Group::look_ahead},
    {150, Group::polar},         {500, Group::scaling},       {501, Group::mirroring},
    {40, Group::non_modal},      {90, Group::non_modal},      {100, Group::non_modal},
    {280, Group::non_modal},     {300, Group::non_modal},     {520, Group::non_modal},
    {530, Group::non_modal},     {920, Group::non_modal},     {921, Group::non_modal},
    {922, Group::non_modal},     {131, Group::cancel},        {401, Group::cancel},
    {670, Group::cancel},        {690, Group::cancel},
};

struct Refused {
  int first;  ///< tenths
  int last;
  const char* why;
};

constexpr Refused refused[] = {
    {52, 53, "splines are not drawn"},
    {70, 70, "the lathe's diameter mode would change the path"},
    {120, 139, "pockets are not drawn"},
    {160, 160, "polar coordinates would change the path"},
    {180, 199, "only the XY plane, G17, is drawn"},
    {270, 309, "moves to stored positions are not drawn"},
    {310, 319, "probing moves are not drawn"},
    {330, 339, "synchronised moves are not drawn"},
    {380, 389, "probing moves are not drawn"},
    {410, 429, "cutter compensation would change the path"},
    {431, 439, "its axis words would be offsets, not moves"},
    {510, 519, "scaling and mirroring would change the path"},
    {541, 599, "only the coordinate system G54 is drawn"},
    {600, 600, "a target from one side overshoots"},
    {650, 679, "macros are not run"},
    {680, 689, "rotation would change the path"},
    {720, 769, "canned cycles are not drawn"},
    {810, 899, "canned cycles are not drawn"},
    {901, 901, "arc centres are incremental, G91.1"},
    {923, 929, "coordinate offsets would change the path"},
    {1100, 1299, "only the coordinate system G54 is drawn"},
    {1540, 1540, "only the coordinate system G54 is drawn"},
};

// Ten times the number where that is a whole number that a code can have, else -1.
int tenths_of(double number) {
  const double tenths = number * 10;
  if (!(tenths >= 0 && tenths < 10000)) return -1;
  const double whole = std::round(tenths);
  return std::abs(tenths - whole) < 1e-6 ? static_cast<int>(whole) : -1;
}

}  // namespace

std::string code_name(char letter, int tenths) {
  std::string name = letter + std::to_string(tenths / 10);
  if (tenths % 10 != 0) name += "." + std::to_string(tenths % 10);
  return name;
}

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
  if (code == 47 || (code >= 96 && code <= 99) || code == 198) {
    why = code_name('M', tenths) + " is not supported: repeats and subprograms are not run";
    return false;
  }
  if (code >= 70 && code <= 73) {
    why = code_name('M', tenths) + " is not supported: saved modes are not restored";
    return false;
  }
  return true;
}

bool takes_arguments(double m_number) {
  return m_number == 92 || m_number == 117 || m_number == 118 || m_number >= 200;
}

bool ends_program(double m_number) { return m_number == 2 || m_number == 30; }

}  // namespace cosim::toolpath
