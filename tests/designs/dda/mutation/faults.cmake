# In model/dda/: the cycle model of the DDA, its oracle, and the device outside.

faults_in(dda/machine.h)
fault("A number of W bits is written as a signed one"
  [[field.format == Format::twos_complement]] [[field.width > 1]])
fault("A register of W bits takes W + 1" [[low_bits(code, field.width)]] [[code]])
fault("A step down changes a rate as one up does"
  [[select(is_set(down), V(0) - by, V(0))]] [[select(is_set(down), by, V(0))]])
fault("A sum of 2^W is no carry"
  [[!(sum < V(shift_left(1, p.width)))]] [[sum > V(shift_left(1, p.width))]])
fault("A sum of 0 is a borrow" [[sum < V(0)]] [[sum < V(1)]])
fault("An axis that has made its steps goes on backwards" [[may_step & borrow]] [[borrow]])
fault("A rate is full with a quarter of the accumulator"
  [[V(shift_left(1, p.width - 1))]] [[V(shift_left(1, p.width - 2))]])
fault("A rate of half of the accumulator is not full backwards"
  [[rate > V(0) - half]] [[rate > V(0) - half - V(1)]])
fault("X steps as long as Y has steps left"
  [[free | !(s.left_x == V(0))]] [[free | (s.left_y > V(0))]])
fault("Y does not make its last step" [[free | !(s.left_y == V(0))]] [[free | (s.left_y > V(1))]])
fault("A step of X changes Y's rate by 2 C"
  [[s.rate_y + x.times(s.two_a)]] [[s.rate_y + x.times(s.two_c)]])
fault("Y's rate follows a step of X at once in parallel, too"
  [[select(is_set(s.sequential), turned, s.rate_y)]] [[turned]])
fault("SX loses its highest bit" [[wrap(sum_x, p.width)]] [[wrap(sum_x, p.width - 1)]])
fault("A step of Y takes all of SY"
  [[wrap(sum_y, p.width)]] [[select(is_set(y.up), V(0), wrap(sum_y, p.width))]])
fault("A step of X changes its own rate the other way"
  [[s.rate_x - x.times(s.b)]] [[s.rate_x + x.times(s.b)]])
fault("A step of Y leaves its own rate" [[turned + y.times(s.b)]] [[turned]])
fault("X does not wrap" [[wrap_signed(p, s.x + x.up - x.down)]] [[s.x + x.up - x.down]])
fault("A free curve counts its steps" [[select(counted, x.up + x.down, V(0))]] [[x.up + x.down]])
fault("Steps of Y down are not counted"
  [[select(counted, y.up + y.down, V(0))]] [[select(counted, y.up, V(0))]])
fault("Y's rate is not shifted" [[n.rate_y = s.rate_y + s.rate_y;]] [[n.rate_y = s.rate_y;]])
fault("Start wins over stop" [[flag<V>(is_set(in.start) & !is_set(in.stop))]] [[in.start]])
fault("A write with a start is none" [[is_set(in.write)]] [[is_set(in.write) & !is_set(in.start)]])
fault("Two modes stand in each other's bit"
  [[flag<V>(bit(in.data, 0))]] [[flag<V>(bit(in.data, 1))]])
fault("A curve once free stays so"
  [[flag<V>(bit(in.data, 2))]] [[flag<V>(bit(in.data, 2) | is_set(s.free))]])
fault("Each register is written at the address before its own"
  [[V(static_cast<int>(i - first) + 1)]] [[V(static_cast<int>(i - first))]])
fault("A curve ends with the first axis that is done"
  [[counted & (s.left_x == V(0)) & (s.left_y == V(0))]]
  [[counted & ((s.left_x == V(0)) | (s.left_y == V(0)))]])
fault("A counted curve is not stopped"
  [[is_set(in.stop) | done]] [[(is_set(in.stop) & !counted) | done]])
fault("Rates are shifted until both are full" [[!is_full(p, s.rate_x) & !is_full(p, s.rate_y)]]
  [[!(is_full(p, s.rate_x) & is_full(p, s.rate_y))]])
fault("A step comes with a shift" [[running & !over & !shift]] [[running & !over]])
fault("Busy ends a clock early"
  [[result.outputs.busy = s.running;]] [[result.outputs.busy = flag<V>(running & !over);]])
fault("A borrow shows while nothing is drawn" [[select(step, a.x.down, V(0))]] [[a.x.down]])
fault("The code of Y is that of X" [[low_bits(s.y, p.width + 1)]] [[low_bits(s.x, p.width + 1)]])
fault("The end of a curve clears the registers"
  [[stopped.running = V(0);]] [[stopped = State<V>{};]])
fault("A shift wins over the end" [[select(over, stopped, select(shift, shifted(s), a.state))]]
  [[select(over & !shift, stopped, select(shift, shifted(s), a.state))]])
fault("A curve that runs is not reset" [[is_set(in.rst)]] [[is_set(in.rst) & !running]])
fault("A curve that runs is written"
  [[is_set(s.running)]] [[is_set(s.running) & !is_set(in.write)]])

faults_in(dda/curve.cpp)
fault("An accumulator that goes backwards starts as one forwards"
  [[backwards ? ones(p.width) - forwards : forwards]] [[forwards]])
fault("An axis with a rate of 0 is taken to go forwards"
  [[rates.x == 0 && (q.c < 0 ? rates.y < 0 : q.c > 0 && rates.y > 0)]] [[false]])
fault("A line has no steps left to go down"
  [[s.left_y = std::abs(to.y);]] [[s.left_y = std::max<std::int64_t>(to.y, 0);]])
fault("An arc goes to the Y axis, wherever it is to end" [[from.x - to.x]] [[from.x]])
fault("An arc may take 2^W clocks" [[shift_left(1, p.width + 2)]] [[shift_left(1, p.width)]])
fault("An arc may end a step off its circle"
  [[std::fabs(radius(from) - radius(to)) >= 1]] [[std::fabs(radius(from) - radius(to)) > 1]])
fault("A turn is half of one" [[2 * std::numbers::pi]] [[std::numbers::pi]])
fault("A rate that is only added is not looked at" [[track.added()]] [[track.rates()]])
fault("A Y that leaves its code is not seen"
  [[!fits(p, at.x) || !fits(p, at.y)]] [[!fits(p, at.x)]])
fault("A number of clocks below 0 is taken"
  [[clocks < 0 || clocks >= most_clocks]] [[clocks >= most_clocks]])

faults_in(dda/conic.cpp)
fault("A coefficient below the least is taken"
  [[-one.largest <= one.value && one.value <= one.largest]] [[one.value <= one.largest]])
fault("Two lines that cross off the origin are a conic" [[b * d * e]] [[0]])
fault("X's rate has B y in place of B x" [[b * x + 2 * c * y]] [[b * y + 2 * c * y]])
fault("A start may be a whole step off"
  [[2 * std::fabs(static_cast<long double>(value))]] [[std::fabs(static_cast<long double>(value))]])
fault("A rate beyond every machine is cut" [[rate >> 62 == 0 || -rate >> 62 == 0]] [[true]])
fault("A parabola has a turn" [[square <= 0]] [[square < 0]])

faults_in(dda/job.cpp)
fault("The host exchanges two modes"
  [[s.sequential + 2 * s.normalise]] [[s.normalise + 2 * s.sequential]])

faults_in(dda/drive.h)
fault("The host starts before the last register is written"
  [[d.written == V(addresses - 1)]] [[d.written == V(addresses - 2)]])
fault("The host stops a clock late" [[!(d.clocks < t.clocks)]] [[d.clocks > t.clocks]])

faults_in(dda/job.cpp)
fault("A job is tried again as a smaller one" [[clocks >= *job.clocks]] [[clocks > *job.clocks]])

faults_in(dda/checker.h)
fault("The check of jobs takes the sum of X for that of Y"
  [[shift_right(to_y, p.width)]] [[shift_right(to_x, p.width)]])
fault("The check of jobs knows no sequential update"
  [[select(sequential, turned_y, w.rate_y)]] [[w.rate_y]])
fault("The check of jobs does not see an end that is too early"
  [[over & !is_set(w.over)]] [[over & is_set(w.over)]])

faults_in(dda/oracle.cpp)
fault("The oracle shifts a line once too often"
  [[(larger << shifts_) >> (width_ - 1) == 0]] [[(larger << shifts_) >> width_ == 0]])
fault("The oracle takes the rates about the origin" [[s.two_c * (p.y - s.y)]] [[s.two_c * p.y]])
fault("The oracle knows no sequential update" [[job_.start.sequential ? moved : at_]] [[at_]])
fault("The oracle stops a clock late" [[clocks_ >= *job_.clocks]] [[clocks_ > *job_.clocks]])
fault("The oracle lets Y step on" [[!counted || left_y_ != 0]] [[true]])

faults_in(dda/equation.cpp)
fault("A line is off by the distance across it"
  [[std::max(std::fabs(along_x), std::fabs(along_y))]] [[std::hypot(along_x, along_y)]])
fault("A conic is off by twice its A" [[two_a / 2 * x * x]] [[two_a * x * x]])
fault("A circle is off by its equation over the gradient of its radius"
  [[from_centre + radius]] [[2 * radius]])
fault("A point is put on the curve in one step" [[i < 8]] [[i < 1]])
