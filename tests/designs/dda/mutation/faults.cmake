# In model/dda/: the cycle model of the DDA, its oracle, and the device outside.

faults_in(dda/dda.h)
fault("A register of W bits takes one bit less" [[take(1, sx, in.data);]]
  [[take(1, sx, UInt<W - 1>(in.data));]])
fault("A step down changes a rate as one up does"
  [[return mux(up, by, mux(down, -by, Number(0)));]] [[return mux(up || down, by, Number(0));]])
fault("A sum of 2^W is no carry" [[sum > UInt<W>(-1)]] [[sum - 1 > UInt<W>(-1)]])
fault("A sum of 0 is a borrow" [[sum < 0]] [[sum < 1]])
fault("An axis that has made its steps goes on backwards" [[may_step && borrow]] [[borrow]])
fault("A rate is full with a quarter of the accumulator"
  [[rate >= half]] [[rate >= half >> 1]])
fault("A rate of half of the accumulator is not full backwards"
  [[rate <= -half]] [[rate < -half]])
fault("Y does not make its last step" [[free || left_y != 0]] [[free || left_y > 1]])
fault("X steps as long as Y has steps left" [[free || left_x != 0]] [[free || left_y != 0]])
fault("A step of X changes Y's rate by 2 C" [[dx.times(two_a)]] [[dx.times(two_c)]])
fault("Y's rate follows a step of X at once in parallel, too"
  [[sy + mux(sequential, turned, rate_y)]] [[sy + turned]])
fault("SX loses its highest bit" [[sx = sum_x;]] [[sx = UInt<W - 1>(sum_x);]])
fault("A step of Y takes all of SY" [[sy = sum_y;]] [[sy = mux(dy.up, 0, sum_y);]])
fault("A step of X changes its own rate the other way"
  [[rate_x - dx.times(b)]] [[rate_x + dx.times(b)]])
fault("A step of Y leaves its own rate" [[rate_y = turned + dy.times(b);]]
  [[rate_y = turned;]])
fault("X does not step past its largest code" [[x = x + dx.up - dx.down;]]
  [[if (!(dx.up && x == UInt<W>(-1))) x = x + dx.up - dx.down;]])
fault("A free curve counts its steps" [[!free && (dx.up || dx.down)]] [[dx.up || dx.down]])
fault("Steps of Y down are not counted" [[!free && (dy.up || dy.down)]] [[!free && dy.up]])
fault("Y's rate is not shifted" [[rate_y = rate_y + rate_y;]] [[rate_y = rate_y + 0;]])
fault("Start wins over stop" [[running = in.start && !in.stop;]] [[running = in.start;]])
fault("A write with a start is none" [[wait(in);]]
  [[In no_write = in; no_write.write = in.write && !in.start; wait(no_write);]])
fault("Two modes stand in each other's bit" [=[in.data[0]]=] [=[in.data[1]]=])
fault("A curve once free stays so" [=[in.data[2]]=] [=[in.data[2] || free]=])
fault("Each register is written at the address before its own"
  [[in.address == address]] [[in.address + 1 == address]])
fault("A curve ends with the first axis that is done"
  [[!free && left_x == 0 && left_y == 0]] [[!free && (left_x == 0 || left_y == 0)]])
fault("A counted curve is not stopped" [[in.stop || is_done()]] [[(in.stop && free) || is_done()]])
fault("Rates are shifted until both are full" [[!is_full(rate_x) && !is_full(rate_y)]]
  [[!(is_full(rate_x) && is_full(rate_y))]])
fault("A step comes with a shift" [[running && !over && !shift]] [[running && !over]])
fault("Busy ends a clock early" [[return out;]]
  [[Out early = out; early.busy = out.busy && !over; return early;]])
fault("A borrow shows while nothing is drawn" [[step && move.x.down]] [[move.x.down]])
fault("The code of Y is that of X" [[Number(y)]] [[Number(x)]])
fault("The end of a curve clears the registers" [[running = false;]] [[*this = Dda{};]])
fault("A shift wins over the end" [[(over)]] [[over && !shift]])
fault("A curve that runs is not reset" [[(in.rst)]] [[in.rst && !running]])
fault("A curve that runs is written" [[(!running)]] [[!running || in.write]])
fault("The host exchanges two modes"
  [[s.sequential + 2 * s.normalise]] [[s.normalise + 2 * s.sequential]])
fault("The host starts before the last register is written"
  [[written == addresses - 1]] [[written == addresses - 2]])
fault("The host stops a clock late" [[running >= job.clocks]] [[running > job.clocks]])
fault("The check of jobs takes the sum of X for that of Y"
  [[step_to(to_y, moves && (!counted || left_y != 0))]]
  [[step_to(to_x, moves && (!counted || left_y != 0))]])
fault("The check of jobs knows no sequential update"
  [[sum_y + mux(at_once, turned_y, rate_y)]] [[sum_y + rate_y]])
fault("The check of jobs does not see an end that is too early"
  [[is_last && !over]] [[is_last && over]])

faults_in(dda/curve.cpp)
fault("An accumulator that goes backwards starts as one forwards"
  [[backwards ? power(width) - 1 - forwards : forwards]] [[forwards]])
fault("An axis with a rate of 0 is taken to go forwards"
  [[rates.x == 0 && (q.c < 0 ? rates.y < 0 : q.c > 0 && rates.y > 0)]] [[false]])
fault("A line has no steps left to go down"
  [[s.left_y = std::abs(to.y);]] [[s.left_y = std::max<std::int64_t>(to.y, 0);]])
fault("An arc goes to the Y axis, wherever it is to end" [[from.x - to.x]] [[from.x]])
fault("An arc may take 2^W clocks" [[power(width + 2)]] [[power(width)]])
fault("An arc may end a step off its circle"
  [[std::fabs(radius(from) - radius(to)) >= 1]] [[std::fabs(radius(from) - radius(to)) > 1]])
fault("A turn is half of one" [[2 * std::numbers::pi]] [[std::numbers::pi]])
fault("A rate that is only added is not looked at" [[track.added()]] [[track.rates()]])
fault("A Y that leaves its code is not seen"
  [[!fits(width, at.x) || !fits(width, at.y)]] [[!fits(width, at.x)]])
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
fault("A job is tried again as a smaller one" [[clocks >= *job.clocks]] [[clocks > *job.clocks]])

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
