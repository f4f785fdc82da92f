#include "model/toolpath/gcode.h"

#include <array>
#include <cmath>

#include "model/toolpath/arc_geometry.h"
#include "model/toolpath/block.h"

namespace cosim::toolpath {

namespace {

constexpr double pm_per_mm = 1e9;
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
      return std::move(program_);
    }
  }

 private:
  void execute(const Block& block);
  void set_modes(const Block& block);
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
  std::array<std::int64_t, other_axes.size()> others_{};
  int motion_mode_ = no_motion_mode;
  bool inches_ = false;
  bool incremental_ = false;
};

void Reader::execute(const Block& block) {
  ++program_.blocks;
  set_modes(block);
  const Token* xy = block.first_of("XY");
  const Token* other = block.first_of(other_axes);
  const Token* arc = block.first_of("IJR");
  const bool arc_mode = motion_mode_ == 20 || motion_mode_ == 30;
  if (const Token* moves = xy ? xy : other) {
    if (block.code(Group::non_modal) == 40) {
      fail_at(*moves, std::string(1, moves->letter) + " beside G4 is either a move or a time");
    }
    if (motion_mode_ == no_motion_mode) {
      fail_at(*moves, std::string(1, moves->letter) + " without a motion mode: G0, G1, G2 or G3");
    }
  }
  if (arc && !arc_mode) {
    fail_at(*arc, std::string(1, arc->letter) + " outside of an arc: it needs G2 or G3");
  }
  move_other_axes(block);
  if (xy || arc || (other && arc_mode)) move_xy(block);
}

void Reader::set_modes(const Block& block) {
  if (block.code(Group::units) >= 0) inches_ = block.code(Group::units) == 200;
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
    const std::int64_t reached = target(block.word(other_axes[i]), others_[i]);
    moved |= reached != others_[i];
    others_[i] = reached;
  }
  program_.other_axis_moves += moved ? 1 : 0;
}

void Reader::move_xy(const Block& block) {
  const Position end{target(block.word('X'), position_.x), target(block.word('Y'), position_.y)};
  const Token* first = block.first_of("XYIJR");
  Motion motion;
  motion.place = first ? first->place : block.place;
  switch (motion_mode_) {
    case 0:
      motion.kind = MotionKind::rapid;
      break;
    case 10:
      motion.kind = MotionKind::feed;
      break;
    case 20:
      motion.kind = MotionKind::arc_cw;
      break;
    default:
      motion.kind = MotionKind::arc_ccw;
  }
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
  if (turns) fail_at(*turns, "P (turns) in an arc is not supported");
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

Program read_gcode_file(const std::string& path) { return read_gcode(read_text(path), path); }

}  // namespace cosim::toolpath
