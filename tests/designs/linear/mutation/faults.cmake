# In model/linear/: the cycle model, its oracle, and the device outside of SU 1631518.

faults_in(linear/machine.h)
fault("A part of a word has one position more" [[left < V(q)]] [[left < V(q - 1)]])
fault("A position takes the bit of the code behind its own"
  [[bit(code, p.m - i)]] [[bit(code, p.m - i - 1)]])
fault("The low bits of the code are in the other order" [[reversed(low_code, p.n)]] [[low_code]])
fault("Position 2^gamma takes a bit on the first word of all"
  [[V(shift_left(1, p.n)) - k]] [[V(shift_left(1, p.n)) - k - V(1)]])
fault("The end of a line leaves the code in force"
  [[s.running = s.formed = s.coded = s.left = s.tick = s.last_bit = V(0);]]
  [[s.running = s.formed = s.left = s.tick = s.last_bit = V(0);]])
fault("The end of a line leaves the count of ticks"
  [[s.running = s.formed = s.coded = s.left = s.tick = s.last_bit = V(0);]]
  [[s.running = s.formed = s.coded = s.left = s.last_bit = V(0);]])
fault("The end of a line leaves the bit of the multiplier"
  [[s.running = s.formed = s.coded = s.left = s.tick = s.last_bit = V(0);]]
  [[s.running = s.formed = s.coded = s.left = s.tick = V(0);]])
fault("A line given up leaves its length"
  [[s.running = s.formed = s.coded = s.left = s.tick = s.last_bit = V(0);]]
  [[s.running = s.formed = s.coded = s.tick = s.last_bit = V(0);]])
fault("A word counts before it is formed"
  [[select(is_set(s.formed), select(s.left < word, V(0), s.left - word), s.left)]]
  [[select(s.left < word, V(0), s.left - word)]])
fault("The count of ticks does not wrap"
  [[n.tick = wrap(s.tick + V(1), p.n);]] [[n.tick = s.tick + V(1);]])
fault("The bit of the multiplier is that of the word before"
  [[n.last_bit = last_bit_of(p, s.low_code, n.tick);]]
  [[n.last_bit = last_bit_of(p, s.low_code, s.tick);]])
fault("A new BP leaves the code of the old one in force" [[n.coded = V(0);]] [[n.coded = s.coded;]])
fault("A start wins over UK" [[is_set(in.write_uk)]] [[is_set(in.write_uk) & !is_set(in.start)]])
fault("UK wins over BP" [[is_set(in.write_bp)]] [[is_set(in.write_bp) & !is_set(in.write_uk)]])
fault("A line starts without a code" [[flag<V>(is_set(in.start) & is_set(s.coded))]] [[in.start]])
fault("One bit too many goes to the multiplier"
  [[low_bits(in.data, p.n)]] [[low_bits(in.data, p.n + 1)]])
fault("The high bits of a second code are not taken" [[n.pattern = pattern_of(p, in.data);]]
  [[n.pattern = select(is_set(s.coded), s.pattern, pattern_of(p, in.data));]])
fault("A write stops a line that runs"
  [[is_set(s.running)]] [[is_set(s.running) & !is_set(in.write_bp)]])
fault("Initial set is not seen while a line runs"
  [[!is_set(in.initial_set_n)]] [[!is_set(in.initial_set_n) & !is_set(s.running)]])
fault("Initial set wins over reset"
  [[is_set(in.reset)]] [[is_set(in.reset) & is_set(in.initial_set_n)]])
fault("Busy follows the first word"
  [[result.outputs.busy = s.running;]] [[result.outputs.busy = s.formed;]])
fault("The strobe comes with the start"
  [[result.outputs.strobe = s.formed;]] [[result.outputs.strobe = s.running;]])
fault("The minor axis steps on past the end"
  [[(shift_left(s.pattern, 1) + s.last_bit) & result.outputs.major]]
  [[shift_left(s.pattern, 1) + s.last_bit]])
fault("Counter 4 counts words of half the length"
  [[shift_right(s.left, p.gamma())]] [[shift_right(s.left, p.gamma() - 1)]])
fault("Counter 4 counts the remainder before a code is written" [[part & is_set(s.coded)]] [[part]])
fault("Trigger 10 shows the bit only with a word"
  [[r.trigger10 = s.last_bit;]] [[r.trigger10 = s.formed;]])

faults_in(linear/drive.h)
fault("The host gives a line up a word late" [[!(d.words < t.words)]] [[d.words > t.words]])

faults_in(linear/checker.h)
fault("The check of jobs knows no last word" [[is_last & !(rest < V(q))]] [[is_last]])
fault("The check of jobs takes even positions for odd ones"
  [[is_even = is_even & !bit(q, i - 1);]] [[is_even = is_even & bit(q, i - 1);]])
fault("The check of jobs does not count the words" [[now == c.due]] [[Condition<V>(true)]])

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

faults_in(linear/reversed.h)
fault("The middle bytes are not exchanged where a word is reversed"
  [[v = exchanged(v, 8, 0xff'00ff);]] [[v = exchanged(v, 8, 0xff);]])
