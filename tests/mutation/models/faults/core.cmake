# In model/core/: how numbers stand for codes, and how jobs are driven.

faults_in(core/value.h)
fault("A code of two's complement has no sign" [[shift_right(shift_left(code, 64 - width), 64 - width)]] [[code]])
fault("A negative code of ones' complement is one less"
  [[code - V(ones(width))]] [[code - V(shift_left(1, width))]])
fault("A negative number has the code of two's complement"
  [[select(v < V(0), v + V(ones(width)), v)]] [[select(v < V(0), v + V(shift_left(1, width)), v)]])
fault("A counter is one bit longer"
  [[return low_bits(v, width);]] [[return low_bits(v, width + 1);]])
fault("A shift by 32 or more loses every bit" [[(n & ~Word{63}) == 0 ? shift_left(v, int(n)) : 0]]
  [[(n & ~Word{31}) == 0 ? shift_left(v, int(n)) : 0]])

faults_in(core/job.h)
fault("The second job of a host is its first one again"
  [=[task_for<Design>(p_, jobs_[job_])]=] [=[task_for<Design>(p_, jobs_[job_ == 1 ? 0 : job_])]=])
fault("A driver goes on from the job before" [[driver_ = driver_for<Design, Word>(p_);]] [[]])
