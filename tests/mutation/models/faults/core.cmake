# In model/core/: how numbers stand for codes.

fault("A code of two's complement has no sign" core/value.h
  [[code - V(shift_left(1, width))]] [[code]])
fault("A negative code of ones' complement is one less" core/value.h
  [[code - V(ones(width))]] [[code - V(shift_left(1, width))]])
fault("A negative number has the code of two's complement" core/value.h
  [[select(v < V(0), v + V(ones(width)), v)]]
  [[select(v < V(0), v + V(shift_left(1, width)), v)]])
fault("A counter is one bit longer" core/value.h
  [[return low_bits(v, width);]] [[return low_bits(v, width + 1);]])
