# In model/dda/: the cycle model of the DDA, its oracle, and the device outside.

fault("A number of W bits is written as a signed one" dda/machine.h
  [[field.format == Format::twos_complement]] [[field.width > 1]])
fault("A register of W bits takes W + 1" dda/machine.h
  [[low_bits(code, field.width)]] [[code]])
fault("A step down changes a rate as one up does" dda/machine.h
  [[select(is_set(down), V(0) - by, V(0))]] [[select(is_set(down), by, V(0))]])
fault("A sum of 2^W is no carry" dda/machine.h
  [[!(sum < V(shift_left(1, p.width)))]] [[sum > V(shift_left(1, p.width))]])
fault("A sum of 0 is a borrow" dda/machine.h
  [[sum < V(0)]] [[sum < V(1)]])
fault("An axis that has made its steps goes on backwards" dda/machine.h
  [[may_step & borrow]] [[borrow]])
fault("A rate is full with a quarter of the accumulator" dda/machine.h
  [[V(shift_left(1, p.width - 1))]] [[V(shift_left(1, p.width - 2))]])
fault("A rate of half of the accumulator is not full backwards" dda/machine.h
  [[rate > V(0) - half]] [[rate > V(0) - half - V(1)]])
fault("X steps as long as Y has steps left" dda/machine.h
  [[free | !(s.left_x == V(0))]] [[free | (s.left_y > V(0))]])
fault("Y does not make its last step" dda/machine.h
  [[free | !(s.left_y == V(0))]] [[free | (s.left_y > V(1))]])
fault("A step of X changes Y's rate by 2 C" dda/machine.h
  [[s.rate_y + x.times(s.two_a)]] [[s.rate_y + x.times(s.two_c)]])
fault("Y's rate follows a step of X at once in parallel, too" dda/machine.h
  [[select(is_set(s.sequential), turned, s.rate_y)]] [[turned]])
fault("SX loses its highest bit" dda/machine.h
  [[wrap(sum_x, p.width)]] [[wrap(sum_x, p.width - 1)]])
fault("A step of Y takes all of SY" dda/machine.h
  [[wrap(sum_y, p.width)]] [[select(is_set(y.up), V(0), wrap(sum_y, p.width))]])
fault("A step of X changes its own rate the other way" dda/machine.h
  [[s.rate_x - x.times(s.b)]] [[s.rate_x + x.times(s.b)]])
fault("A step of Y leaves its own rate" dda/machine.h
  [[turned + y.times(s.b)]] [[turned]])
fault("X does not wrap" dda/machine.h
  [[wrap_signed(p, s.x + x.up - x.down)]] [[s.x + x.up - x.down]])
fault("A free curve counts its steps" dda/machine.h
  [[select(counted, x.up + x.down, V(0))]] [[x.up + x.down]])
fault("Steps of Y down are not counted" dda/machine.h
  [[select(counted, y.up + y.down, V(0))]] [[select(counted, y.up, V(0))]])
fault("Y's rate is not shifted" dda/machine.h
  [[n.rate_y = s.rate_y + s.rate_y;]] [[n.rate_y = s.rate_y;]])
fault("Start wins over stop" dda/machine.h
  [[flag<V>(is_set(in.start) & !is_set(in.stop))]] [[in.start]])
fault("A write with a start is none" dda/machine.h
  [[is_set(in.write)]] [[is_set(in.write) & !is_set(in.start)]])
fault("Two modes stand in each other's bit" dda/machine.h
  [[flag<V>(bit(in.data, 0))]] [[flag<V>(bit(in.data, 1))]])
fault("A curve once free stays so" dda/machine.h
  [[flag<V>(bit(in.data, 2))]] [[flag<V>(bit(in.data, 2) | is_set(s.free))]])
fault("Each register is written at the address before its own" dda/machine.h
  [[V(static_cast<int>(i - first) + 1)]] [[V(static_cast<int>(i - first))]])
fault("A curve ends with the first axis that is done" dda/machine.h
  [[counted & (s.left_x == V(0)) & (s.left_y == V(0))]]
  [[counted & ((s.left_x == V(0)) | (s.left_y == V(0)))]])
fault("A counted curve is not stopped" dda/machine.h
  [[is_set(in.stop) | done]] [[(is_set(in.stop) & !counted) | done]])
fault("Rates are shifted until both are full" dda/machine.h
  [[!is_full(p, s.rate_x) & !is_full(p, s.rate_y)]]
  [[!(is_full(p, s.rate_x) & is_full(p, s.rate_y))]])
fault("A step comes with a shift" dda/machine.h
  [[running & !over & !shift]] [[running & !over]])
fault("Busy ends a clock early" dda/machine.h
  [[result.outputs.busy = s.running;]] [[result.outputs.busy = flag<V>(running & !over);]])
fault("A borrow shows while nothing is drawn" dda/machine.h
  [[select(step, a.x.down, V(0))]] [[a.x.down]])
fault("The code of Y is that of X" dda/machine.h
  [[low_bits(s.y, p.width + 1)]] [[low_bits(s.x, p.width + 1)]])
fault("The end of a curve clears the registers" dda/machine.h
  [[stopped.running = V(0);]] [[stopped = State<V>{};]])
fault("A shift wins over the end" dda/machine.h
  [[select(over, stopped, select(shift, shifted(s), a.state))]]
  [[select(over & !shift, stopped, select(shift, shifted(s), a.state))]])
fault("A curve that runs is not reset" dda/machine.h
  [[is_set(in.rst)]] [[is_set(in.rst) & !running]])
fault("A curve that runs is written" dda/machine.h
  [[is_set(s.running)]] [[is_set(s.running) & !is_set(in.write)]])

fault("An accumulator that goes backwards starts as one forwards" dda/curve.cpp
  [[backwards ? ones(p.width) - forwards : forwards]] [[forwards]])
fault("An axis with a rate of 0 is taken to go forwards" dda/curve.cpp
  [[rates.x == 0 && (q.c < 0 ? rates.y < 0 : q.c > 0 && rates.y > 0)]] [[false]])
fault("A line has no steps left to go down" dda/curve.cpp
  [[s.left_y = std::abs(to.y);]] [[s.left_y = std::max<std::int64_t>(to.y, 0);]])
fault("An arc goes to the Y axis, wherever it is to end" dda/curve.cpp
  [[from.x - to.x]] [[from.x]])
fault("An arc may take 2^W clocks" dda/curve.cpp
  [[shift_left(1, p.width + 2)]] [[shift_left(1, p.width)]])
fault("An arc may end a step off its circle" dda/curve.cpp
  [[std::fabs(radius(from) - radius(to)) >= 1]] [[std::fabs(radius(from) - radius(to)) > 1]])
fault("A turn is half of one" dda/curve.cpp
  [[2 * std::numbers::pi]] [[std::numbers::pi]])
fault("A rate that is only added is not looked at" dda/curve.cpp
  [[track.added()]] [[track.rates()]])
fault("A Y that leaves its code is not seen" dda/curve.cpp
  [[!fits(p, at.x) || !fits(p, at.y)]] [[!fits(p, at.x)]])
fault("A number of clocks below 0 is taken" dda/curve.cpp
  [[clocks < 0 || clocks >= most_clocks]] [[clocks >= most_clocks]])

fault("A coefficient below the least is taken" dda/conic.cpp
  [[-one.largest <= one.value && one.value <= one.largest]] [[one.value <= one.largest]])
fault("Two lines that cross off the origin are a conic" dda/conic.cpp
  [[b * d * e]] [[0]])
fault("X's rate has B y in place of B x" dda/conic.cpp
  [[b * x + 2 * c * y]] [[b * y + 2 * c * y]])
fault("A start may be a whole step off" dda/conic.cpp
  [[2 * std::fabs(static_cast<long double>(value))]] [[std::fabs(static_cast<long double>(value))]])
fault("A rate beyond every machine is cut" dda/conic.cpp
  [[rate >> 62 == 0 || -rate >> 62 == 0]] [[true]])
fault("A parabola has a turn" dda/conic.cpp
  [[square <= 0]] [[square < 0]])

fault("The host exchanges two modes" dda/job.cpp
  [[s.sequential + 2 * s.normalise]] [[s.normalise + 2 * s.sequential]])
fault("The host starts before the last register is written" dda/drive.h
  [[d.written == V(addresses - 1)]] [[d.written == V(addresses - 2)]])
fault("The host stops a clock late" dda/drive.h
  [[!(d.clocks < t.clocks)]] [[d.clocks > t.clocks]])
fault("A job is tried again as a smaller one" dda/job.cpp
  [[clocks >= *job.clocks]] [[clocks > *job.clocks]])

fault("The check of jobs takes the sum of X for that of Y" dda/checker.h
  [[shift_right(to_y, p.width)]] [[shift_right(to_x, p.width)]])
fault("The check of jobs knows no sequential update" dda/checker.h
  [[select(sequential, turned_y, w.rate_y)]] [[w.rate_y]])
fault("The check of jobs does not see an end that is too early" dda/checker.h
  [[over & !is_set(w.over)]] [[over & is_set(w.over)]])

fault("The oracle shifts a line once too often" dda/oracle.cpp
  [[(larger << shifts_) >> (width_ - 1) == 0]] [[(larger << shifts_) >> width_ == 0]])
fault("The oracle takes the rates about the origin" dda/oracle.cpp
  [[s.two_c * (p.y - s.y)]] [[s.two_c * p.y]])
fault("The oracle knows no sequential update" dda/oracle.cpp
  [[job_.start.sequential ? moved : at_]] [[at_]])
fault("The oracle stops a clock late" dda/oracle.cpp
  [[clocks_ >= *job_.clocks]] [[clocks_ > *job_.clocks]])
fault("The oracle lets Y step on" dda/oracle.cpp
  [[!counted || left_y_ != 0]] [[true]])
fault("A line is off by the distance across it" dda/equation.cpp
  [[std::max(std::fabs(along_x), std::fabs(along_y))]] [[std::hypot(along_x, along_y)]])
fault("A conic is off by twice its A" dda/equation.cpp
  [[two_a / 2 * x * x]] [[two_a * x * x]])
fault("A circle is off by its equation over the gradient of its radius" dda/equation.cpp
  [[from_centre + radius]] [[2 * radius]])
fault("A point is put on the curve in one step" dda/equation.cpp
  [[i < 8]] [[i < 1]])
