# In model/core/: how numbers stand for codes, and how jobs are driven.

fault("A code of two's complement has no sign" core/value.h
  [[code - V(shift_left(1, width))]] [[code]])
fault("A negative code of ones' complement is one less" core/value.h
  [[code - V(ones(width))]] [[code - V(shift_left(1, width))]])
fault("A negative number has the code of two's complement" core/value.h
  [[select(v < V(0), v + V(ones(width)), v)]]
  [[select(v < V(0), v + V(shift_left(1, width)), v)]])
fault("A counter is one bit longer" core/value.h
  [[return low_bits(v, width);]] [[return low_bits(v, width + 1);]])
fault("A shift by 32 or more loses every bit" core/value.h
  [[(n & ~Word{63}) == 0 ? shift_left(v, int(n)) : 0]]
  [[(n & ~Word{31}) == 0 ? shift_left(v, int(n)) : 0]])
fault("A parity is that of too few bits" core/bit_strings.h
  [[half < width]] [[half + 1 < width]])
fault("A joined part keeps the bits above it" core/bit_strings.h
  [[low_bits(low, width_of_low)]] [[low]])
fault("An array is written at its first element" core/memory.h
  [[array[static_cast<int>(index)] = value;]] [[array[0] = value;]])

fault("The second job of a host is its first one again" core/job.h
  [=[task_for<Design>(p_, jobs_[job_])]=] [=[task_for<Design>(p_, jobs_[job_ == 1 ? 0 : job_])]=])
fault("A driver goes on from the job before" core/job.h
  [[driver_ = {};]] [[]])
