# In model/linear/: the cycle model, its oracle, and the device outside of SU 1631518.

faults_in(linear/linear.h)
fault("A part of a word has one position more" [[~(Positions(-1) >> k)]]
  [[~(Positions(-1) >> UInt<gamma + 1>(k + 1))]])
fault("A position takes the bit of the code behind its own" [=[code[M - i]]=] [=[code[M - i - 1]]=])
fault("The low bits of the code are in the other order"
  [=[register3[N - i]]=] [=[register3[i - 1]]=])
fault("Position 2^gamma takes no bit on an odd word" [=[k[i - 1]]=] [=[k[i]]=])
fault("The end of a line leaves the code in force"
  [[*this = Linear{.register3 = register3, .register9 = register9};]]
  [[*this =
        Linear{.trigger32 = trigger32, .register3 = register3, .register9 = register9};]])
fault("The end of a line leaves the count of ticks"
  [[*this = Linear{.register3 = register3, .register9 = register9};]]
  [[*this =
        Linear{.multiplier6 = multiplier6, .register3 = register3, .register9 = register9};]])
fault("The end of a line leaves the bit of the multiplier"
  [[*this = Linear{.register3 = register3, .register9 = register9};]]
  [[*this =
        Linear{.register3 = register3, .register9 = register9, .trigger10 = trigger10};]])
fault("A line given up leaves its length"
  [[*this = Linear{.register3 = register3, .register9 = register9};]]
  [[*this =
        Linear{.counter4 = counter4, .register3 = register3, .register9 = register9};]])
fault("A word counts before it is formed" [[trigger31 = in.start && trigger32;]]
  [[trigger31 = trigger32 && in.start; counter4 = counter4 - trigger31;]])
fault("A line starts without a code" [[trigger31 = in.start && trigger32;]]
  [[trigger31 = in.start;]])
fault("The bit of the multiplier is that of the word before"
  [[end_of_word(multiplier6)]] [[end_of_word(multiplier6 - 1)]])
fault("A new BP leaves the code of the old one in force" [[register5 = in.data;
      trigger32 = 0;]] [[register5 = in.data;]])
fault("A start wins over UK" [[prepare(in);]]
  [[In other = in; if (in.start) other.write_uk = 0; prepare(other);]])
fault("UK wins over BP" [[prepare(in);]]
  [[In other = in; if (in.write_uk) other.write_bp = 0; prepare(other);]])
fault("A write stops a line that runs" [[form();]]
  [[if (in.write_bp) { prepare(In(in)); } else { form(); }]])
fault("The high bits of a second code are not taken" [[register9 = within_word(in.data);]]
  [[if (!trigger32) register9 = within_word(in.data);]])
fault("Initial set is not seen while a line runs"
  [[!in.initial_set_n || (trigger31 && counter4 == 0)]]
  [[(!in.initial_set_n && !trigger31) || (trigger31 && counter4 == 0)]])
fault("Initial set wins over reset" [[*this = Linear{};]]
  [[if (in.initial_set_n) { *this = Linear{}; } else { forget(); }]])
fault("Busy follows the first word" [[return out;]]
  [[Out other = out; other.busy = out.strobe; return other;]])
fault("The strobe comes with the start" [[return out;]]
  [[Out other = out; other.strobe = out.busy; return other;]])
fault("The minor axis steps on past the end"
  [[cat(register9, trigger10) & live]] [[cat(register9, trigger10)]])
fault("Counter 4 counts the remainder before a code is written"
  [[counter4 = in.data >> gamma;]]
  [[counter4 = in.data / positions + (UInt<gamma>(in.data) != 0);]])
fault("Counter 4 counts words of half the length"
  [[in.data >> gamma]] [[in.data >> (gamma - 1)]])
fault("A code written twice counts the remainder twice"
  [[!trigger32 && register5 != 0]] [[register5 != 0]])
fault("The host gives a line up a word late" [[words >= job.words]] [[words > job.words]])
fault("The check of jobs knows no last word" [[first(job.bp)]] [[whole]])
fault("The check of jobs reads the low bits of the code from the other end"
  [=[job.uk[N - i]]=] [=[job.uk[i - 1]]=])
fault("The check of jobs does not count the words" [[words != due]] [[Bit(0)]])

faults_in(linear/control_code.cpp)
fault("A weight has no rounding" [[(major >> (i - 1) & 1)]] [[std::int64_t{0}]])
fault("Of equal codes the larger is the best"
  [[max_deviation(m, major, greedy) < max_deviation(m, major, other) ? greedy : other]]
  [[max_deviation(m, major, other) < max_deviation(m, major, greedy) ? other : greedy]])
fault("There is never a second code"
  [[return greedy - (Code{1} << (m - last));]] [[return greedy;]])
fault("A deviation to the other side does not count" [[std::max(high, -low)]] [[high]])
fault("Positions with a digit of BP at 0 are left out"
  [[std::max(free_high, high + gain)]] [[high + gain]])
fault("A line of all minor steps is refused"
  [[minor < 0 || minor > major]] [[minor < 0 || minor >= major]])

faults_in(linear/oracle.cpp)
fault("The oracle counts the bits of the code from the other end"
  [[(code >> (m - i) & 1) != 0]] [[(code >> (i - 1) & 1) != 0]])
fault("The oracle has a tick more for a line of whole words"
  [[whole << gamma != major ? 1 : 0]] [[1]])
fault("The oracle leaves the last position out"
  [[p <= line.major - before]] [[p < line.major - before]])
