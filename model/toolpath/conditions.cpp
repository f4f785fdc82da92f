#include "model/toolpath/conditions.h"

#include <cmath>
#include <string>

namespace cosim::toolpath {

namespace {

std::string g(int tenths) { return code_name('G', tenths); }
std::string letter_of(const Token& word) { return std::string(1, word.letter); }

void refuse_axes(const Block& block, std::string_view name, bool motion_mode) {
  const Token* axis = block.first_of(axes);
  if (!axis) return;
  const int non_modal = block.code(Group::non_modal);
  if (non_modal == 40 && (motion_mode || block.first_of("YZABCVW")))
    fail(name, axis->place, letter_of(*axis) + " beside G4 is either a move or a time");
  const bool reset = non_modal == 921 || non_modal == 922;
  for (const int code :
       {block.code(Group::scaling), block.code(Group::mirroring), reset ? non_modal : -1}) {
    if (code < 0) continue;
    fail(name, axis->place,
         letter_of(*axis) + " beside " + g(code) + " is either a move or its argument");
  }
}

void refuse_splines(const Block& block, std::string_view name) {
  const int code = block.code(Group::look_ahead);
  if (code != 50 && code != 51) return;
  const Token* mode = block.word(code == 50 ? 'P' : 'Q');
  const bool known = mode && (mode->value == 0 || mode->value == (code == 50 ? 10000 : 1));
  if (known && !block.first_of("XYZABCUVWIJK")) return;
  fail(name, block.place_of(Group::look_ahead),
       g(code) + " is not supported: it is no look-ahead mode (" +
           (code == 50 ? "G5 P0 or P10000" : "G5.1 Q0 or Q1") + "), and splines are not drawn");
}

void refuse_coordinate_systems(const Block& block, std::string_view name) {
  const Token* p = block.word('P');
  if (p && block.code(Group::coordinates) == 540) {
    const bool tolerance =
        block.code(Group::path_control) == 640 && std::floor(p->value) != p->value;
    if (!tolerance) fail(name, p->place, "P beside G54 names another coordinate system");
  }
  const Token* h = block.word('H');
  if (h && block.code(Group::polar) == 150 && block.code(Group::length_offset) < 0) {
    fail(name, h->place, "H beside G15 names another coordinate system");
  }
}

void refuse_arguments(const Block& block, std::string_view name) {
  const int units = block.code(Group::units);
  const Token* cycle = block.first_of("PQUWD");
  if (cycle && (units == 700 || units == 710)) {
    fail(
        name, block.place_of(Group::units),
        g(units) + " with " + letter_of(*cycle) + " is not supported: canned cycles are not drawn");
  }
  const Token* moves = block.first_of("XYIJR");
  if (moves && block.arguments) {
    fail(name, moves->place,
         letter_of(*moves) + " beside an M code that takes arguments may be one");
  }
  const Token* k = block.word('K');
  if (k && k->value != 0) {
    fail(name, k->place, "K is not supported: it belongs to arcs in other planes than G17");
  }
  const Token* e = block.word('E');
  if (e && block.code(Group::look_ahead) != 1870) fail(name, e->place, "unknown word E");
  const Token* l = block.word('L');
  if (l && block.code(Group::non_modal) != 100) fail(name, l->place, "unknown word L");
}

}  // namespace

void check_conditions(const Block& block, std::string_view name, bool motion_mode) {
  refuse_arguments(block, name);
  refuse_splines(block, name);
  refuse_coordinate_systems(block, name);
  refuse_axes(block, name, motion_mode);
}

}  // namespace cosim::toolpath
