#include "model/toolpath/gcode.h"

#include <array>
#include <cmath>
#include <optional>

#include "model/toolpath/arc_geometry.h"
#include "model/toolpath/block.h"
#include "model/toolpath/conditions.h"

namespace cosim::toolpath {

namespace {

constexpr double reach_mm = 1e9;
constexpr int no_motion_mode = -1;  // at the start

PointMm in_mm(Position p) {
  return {static_cast<double>(p.x) / pm_per_mm, static_cast<double>(p.y) / pm_per_mm};
}

// Angles of A, B and C do not scale with the units of length.
bool is_length(char letter) { return letter < 'A' || letter > 'C'; }

class Reader {
 public:
  Reader(std::string_view text, const std::string& name) : lexer_(text, name) {
    program_.name = name;
    others_.fill(0);
  }

  Program read() {
    Block block;
    for (;;) {
      read_block(lexer_, program_.name, block);
      // What stands after the last line's end is a line only where it holds something.
      if (!block.empty || !block.last_of_text || block.place.column > 1) ++program_.lines;
      if (!block.empty) execute(block);
      if (!block.last_of_text && !block.stops) continue;
      if (program_.motions.empty()) {
        fail(program_.name, block.place, "the program ends without a motion in X or Y");
      }
      program_.lines_unread = lexer_.lines_left();
      return std::move(program_);
    }
  }

 private:
  void execute(const Block& block);
  void set_modes(const Block& block);
  void check_moves(const Block& block) const;
  bool leaves_xy(const Block& block);
  void move_to_stored(const Block& block);
  void move_in_machine(const Block& block);
  void set_offsets(const Block& block);
  void move_other_axes(const Block& block);
  void move_xy(const Block& block);
  void trace_arc(const Block& block, Position target, Motion& motion);
  std::int64_t in_pm(const Token& word) const;
  std::int64_t target(const Token* word, std::int64_t present) const;
  [[noreturn]] void fail_at(const Token& word, const std::string& what) const {
    fail(program_.name, word.place, what);
  }

  Lexer lexer_;
  Program program_;
  Position position_;
  // None where the place is the machine's.
  std::array<std::optional<std::int64_t>, other_axes.size()> others_;
  int motion_mode_ = no_motion_mode;
  bool inches_ = false;
  bool incremental_ = false;
};

void Reader::execute(const Block& block) {
  ++program_.blocks;
  set_modes(block);
  check_conditions(block, program_.name, motion_mode_ != no_motion_mode);
  if (leaves_xy(block)) return;
  check_moves(block);
  move_other_axes(block);
  const bool arc_mode = motion_mode_ == 20 || motion_mode_ == 30;
  if (block.first_of("XYIJKR") || (arc_mode && block.first_of(other_axes))) move_xy(block);
}

void Reader::check_moves(const Block& block) const {
  const Token* xy = block.first_of("XY");
  const Token* moves = xy ? xy : block.first_of(other_axes);
  if (moves && motion_mode_ == no_motion_mode) {
    fail_at(*moves, std::string(1, moves->letter) + " without a motion mode: G0, G1, G2 or G3");
  }
  const Token* arc = block.first_of("IJKR");
  if (arc && motion_mode_ != 20 && motion_mode_ != 30) {
    fail_at(*arc, std::string(1, arc->letter) + " outside of an arc: it needs G2 or G3");
  }
}

// Whether the block's G code takes its axis words, and has left X and Y where they are.
bool Reader::leaves_xy(const Block& block) {
  const int look_ahead = block.code(Group::look_ahead);
  if (look_ahead == 50 || look_ahead == 51) return true;
  switch (block.code(Group::non_modal)) {
    case 280:
    case 300:
      move_to_stored(block);
      return true;
    case 530:
      move_in_machine(block);
      return true;
    case 100:
    case 520:
    case 920:
      set_offsets(block);
      return true;
    case 40:  // axis words beside it are a time, unless they were refused
      return block.first_of(axes) && !block.first_of("IJKR");
    default:
      return false;
  }
}

// G28 and G30 move the axes they name, and all of them where they name none.
void Reader::move_to_stored(const Block& block) {
  const std::string code = code_name('G', block.code(Group::non_modal));
  if (const Token* word = block.first_of("XYIJKR")) {
    fail_at(*word, std::string(1, word->letter) + " beside " + code +
                       " is not supported: moves to stored positions are not drawn");
  }
  if (!block.first_of(other_axes)) {
    fail(program_.name, block.place_of(Group::non_modal),
         code + " without axis words is not supported: moves to stored positions are not drawn");
  }
  move_in_machine(block);
}

void Reader::move_in_machine(const Block& block) {
  if (const Token* word = block.first_of("XYIJKR")) {
    fail_at(*word, std::string(1, word->letter) +
                       " beside G53 is not supported: moves in machine coordinates are not drawn");
  }
  bool moved = false;
  for (std::size_t i = 0; i < other_axes.size(); ++i) {
    if (!block.word(other_axes[i])) continue;
    others_[i].reset();
    moved = true;
  }
  program_.other_axis_moves += moved ? 1 : 0;
}

// G10, G52 and G92. Where they leave the coordinates of X and Y what they are, the path stays.
void Reader::set_offsets(const Block& block) {
  const int code = block.code(Group::non_modal);
  const auto refuse = [&](Place place) {
    fail(program_.name, place,
         code_name('G', code) +
             " is not supported here: it sets offsets that would change the path");
  };
  const Token* l = block.word('L');
  const bool here = code == 920 || (l && l->value == 20);  // the words are the present position's
  if (code == 100 && !(l && (l->value == 2 || l->value == 20)))
    refuse(block.place_of(Group::non_modal));
  if (const Token* word = block.first_of("IJKR")) refuse(word->place);
  if (!block.first_of(axes) && !block.word('S')) refuse(block.place_of(Group::non_modal));
  for (const char axis : {'X', 'Y'}) {
    const Token* word = block.word(axis);
    if (!word) continue;
    const std::int64_t stays = !here ? 0 : axis == 'X' ? position_.x : position_.y;
    const bool absolute = code == 100 && !here;  // the place of an origin on the machine
    if (absolute || in_pm(*word) != stays) refuse(word->place);
  }
  for (std::size_t i = 0; i < other_axes.size(); ++i) {
    const Token* word = block.word(other_axes[i]);
    if (!word) continue;
    others_[i].reset();
    if (here) others_[i] = in_pm(*word);
  }
}

void Reader::set_modes(const Block& block) {
  const int units = block.code(Group::units);
  if (units >= 0) inches_ = units == 200 || units == 700;
  if (block.code(Group::distance) >= 0) incremental_ = block.code(Group::distance) == 910;
  if (block.code(Group::motion) >= 0) motion_mode_ = block.code(Group::motion);
}

// A length or an angle in 1e-9 of its unit.
std::int64_t Reader::in_pm(const Token& word) const {
  const double value = word.value * (inches_ && is_length(word.letter) ? 25.4 : 1.0);
  if (!(std::abs(value) <= reach_mm)) {
    fail_at(word, std::string(1, word.letter) + " is out of reach: more than 1e9 mm");
  }
  return std::llround(value * pm_per_mm);
}

std::int64_t Reader::target(const Token* word, std::int64_t present) const {
  if (!word) return present;
  const std::int64_t reached = in_pm(*word) + (incremental_ ? present : 0);
  if (std::abs(reached) > static_cast<std::int64_t>(reach_mm * pm_per_mm)) {
    fail_at(*word, std::string(1, word->letter) + " goes out of reach: more than 1e9 mm");
  }
  return reached;
}

void Reader::move_other_axes(const Block& block) {
  bool moved = false;
  for (std::size_t i = 0; i < other_axes.size(); ++i) {
    const Token* word = block.word(other_axes[i]);
    if (!word) continue;
    const std::int64_t reached = target(word, others_[i].value_or(0));
    if (!others_[i] && incremental_) {
      moved |= word->value != 0;
    } else {
      moved |= others_[i] != reached;
      others_[i] = reached;
    }
  }
  program_.other_axis_moves += moved ? 1 : 0;
}

void Reader::move_xy(const Block& block) {
  const Position end{target(block.word('X'), position_.x), target(block.word('Y'), position_.y)};
  const Token* first = block.first_of("XYIJR");
  Motion motion;
  motion.place = first ? first->place : block.place;
  motion.kind = motion_mode_ == 0    ? MotionKind::rapid
                : motion_mode_ == 10 ? MotionKind::feed
                : motion_mode_ == 20 ? MotionKind::arc_cw
                                     : MotionKind::arc_ccw;
  if (is_arc(motion.kind)) {
    trace_arc(block, end, motion);
  } else if (end == position_) {
    return;
  }
  if (program_.motions.size() == max_motions) {
    fail(program_.name, motion.place,
         "the program is too long: more than " + std::to_string(max_motions) + " motions");
  }
  motion.start = in_mm(position_);
  motion.end = in_mm(end);
  program_.motions.push_back(motion);
  position_ = end;
}

void Reader::trace_arc(const Block& block, Position end, Motion& motion) {
  const Token* r = block.word('R');
  const Token* offset = block.first_of("IJ");
  const std::string code = motion.kind == MotionKind::arc_cw ? "G2" : "G3";
  const Token* turns = block.word('P');
  if (turns && turns->value != 1)
    fail_at(*turns, "P other than 1 (turns) in an arc is not supported");
  if (r && offset) fail_at(*r, "R beside I or J in an arc");
  if (!r && !offset) fail(program_.name, motion.place, code + " needs a radius: I, J or R");

  const bool clockwise = motion.kind == MotionKind::arc_cw;
  const double floor_mm = inches_ ? 0.0005 * 25.4 : 0.005;
  const Token* i_word = block.word('I');
  const Token* j_word = block.word('J');
  const Position to_centre{i_word ? in_pm(*i_word) : 0, j_word ? in_pm(*j_word) : 0};
  const ArcGeometry arc = r ? arc_of_radius(position_, end, in_pm(*r), clockwise, floor_mm)
                            : arc_about(position_, end, to_centre, clockwise, floor_mm);
  if (!arc.wrong.empty()) fail(program_.name, motion.place, arc.wrong);
  motion.centre = in_mm(arc.centre);
  motion.sweep = arc.sweep;
  motion.full_circle = end == position_;
}

}  // namespace

Program read_gcode(std::string_view text, const std::string& name) {
  return Reader(text, name).read();
}

}  // namespace cosim::toolpath
