# In model/circular/: the cycle model, its oracle, and the device outside of SU 1665343.

faults_in(circular/machine.h)
fault("CT8 falls by one on a diagonal step" [[select(diagonal, V(2), V(1))]] [[V(1)]])
fault("CT7 does not wrap" [[wrap_end_around(s.ct7 + select(sector2, V(-1), V(1)), p.width + 1)]]
  [[s.ct7 + select(sector2, V(-1), V(1))]])
fault("A negative CT7 counts as a positive one"
  [[select(n.ct7 < V(0), V(0) - twice7, V(-1) - twice7)]] [[V(-1) - V(0) - twice7]])
fault("A straight step of sector 1 adds -2Y + 1" [[V(-1) - twice7]] [[V(1) - twice7]])
fault("A negative CT8 counts as a positive one in sector 2"
  [[select(n.ct8 < V(0), twice8 - V(1), twice8)]] [[twice8]])
fault("A diagonal step of sector 1 adds 2(X - Y) - 2" [[twice8 + V(1)]] [[twice8]])
fault("A straight step of sector 2 adds 2X - 3" [[twice7 + V(1)]] [[twice7 - V(1)]])
fault("A diagonal step to X = Y adds nothing"
  [[n.f = wrap_end_around(s.f + shift_left(whole, 2), p.width + 4);]]
  [[n.f = select(diagonal & !sector2 & (n.ct8 == V(-1)), s.f,
                 wrap_end_around(s.f + shift_left(whole, 2), p.width + 4));]])
fault("The variants are taken for each other" [[bit(s.ct8, 0)]] [[!bit(s.ct8, 0)]])
fault("Variant -2 finds X at Y" [[s.ct7 - select(level, V(0), V(1))]] [[s.ct7]])
fault("The correction leaves CT7 at X" [[n.ct7 = x - V(1);]] [[n.ct7 = x;]])
fault("The correction leaves CT8 at 0 for both variants"
  [[n.ct8 = select(level, V(0), V(-1));]] [[n.ct8 = V(0);]])
fault("Variant -2 adds 2X" [[x + x + select(level, V(0), V(1))]] [[x + x]])
fault("A start needs a load"
  [[n.t4 = in.start;]] [[n.t4 = flag<V>(is_set(in.start) & is_set(in.load));]])
fault("Sector 2 is forgotten before the start"
  [[flag<V>(is_set(s.t16) | is_set(in.sector2))]] [[in.sector2]])
fault("F is loaded with the fraction .00"
  [[shift_left(from_twos_complement(in.f, p.width + 2), 2) + V(3)]]
  [[shift_left(from_twos_complement(in.f, p.width + 2), 2)]])
fault("A second load leaves CT8"
  [[n.ct8 = select(load, from_ones_complement(in.ct8, p.width + 1), s.ct8);]]
  [[n.ct8 = select(load & (s.ct8 == V(0)), from_ones_complement(in.ct8, p.width + 1), s.ct8);]])
fault("A negative CT7 ends no arc in sector 1"
  [[running & (s.ct7 < V(0))]] [[running & (s.ct7 < V(0)) & sector2]])
fault("The sector changes at X - Y = 1"
  [[running & !sector2 & (s.ct8 < V(0))]] [[running & !sector2 & (s.ct8 < V(1))]])
fault("A step comes with stop"
  [[running & !finish & !correct & !stop]] [[running & !finish & !correct]])
fault("No step comes with reset"
  [[step & (diagonal | !sector2)]] [[step & (diagonal | !sector2) & !is_set(in.rst)]])
fault("The sign of F is taken the wrong way round" [[!(s.f > V(0))]] [[s.f > V(0)]])
fault("A straight step of sector 2 is none" [[step & (diagonal | sector2)]] [[step & diagonal]])
fault("Stop ends nothing" [[is_set(in.rst) | stop | finish]] [[is_set(in.rst) | finish]])
fault("An arc that runs is loaded" [[return corrected(p, s);]] [[return idle(p, s, in);]])
fault("The zero of F is +0"
  [[to_ones_complement_minus_zero(s.f, p.width + 4)]] [[to_ones_complement(s.f, p.width + 4)]])

faults_in(circular/drive.h)
fault("The host stops an arc a step late" [[!(d.steps < t.count)]] [[d.steps > t.count]])

faults_in(circular/job.cpp)
fault("The host sends F in ones' complement"
  [[low_bits(s.f, p.width + 2)]] [[low_bits(to_ones_complement(s.f, p.width + 2), p.width + 2)]])

faults_in(circular/drive.h)
fault("The host starts every arc in sector 1" [[in.sector2 = t.sector2;]] [[in.sector2 = V(0);]])

faults_in(circular/checker.h)
fault("The check of jobs does not look whether the circle is nearer"
  [[outer ^ below]] [[outer & !outer]])
fault("The check of jobs takes a point on the edge for one beyond"
  [[sector1 ^ outer]] [[outer & sector1]])

faults_in(circular/arc.cpp)
fault("X = Y belongs to sector 1" [[p.x > p.y]] [[p.x >= p.y]])
fault("A root is rounded up from the half on"
  [[q - root * root > root]] [[q - root * root >= root]])
fault("F of sector 1 starts at R^2 - (X - 1/2)^2 - Y^2"
  [[radius2 - x * x + x - (y + 1) * (y + 1) - 1]] [[radius2 - x * x + x - y * y - 1]])
fault("F of sector 2 starts with the sign of Y turned"
  [[radius2 - (x - 1) * (x - 1) - y * y - y - 1]] [[radius2 - (x - 1) * (x - 1) - y * y + y - 1]])
fault("The sector is found a row late"
  [[y < radius2 - 2 * y * y ? y + 1 : y]] [[y <= radius2 - 2 * y * y ? y + 1 : y]])
fault("An arc to a point of sector 2 starts at the change"
  [[change.y - start.y + std::max<std::int64_t>(change.x - goal.x, 0)]] [[change.y - start.y]])

faults_in(circular/oracle.cpp)
fault("The oracle steps inward from a point on the circle"
  [[nearest_on(p.y + 1, radius2) < p.x]] [[nearest_on(p.y + 1, radius2) <= p.x]])
fault("The oracle steps up in sector 2 whenever it may"
  [[nearest_on(p.x - 1, radius2) > p.y]] [[nearest_on(p.x - 1, radius2) >= p.y]])
fault("A point outside has a deviation of 0"
  [[at > radius2 ? at - radius2 : radius2 - at]] [[at > radius2 ? Uint128{0} : radius2 - at]])

faults_in(circular/ones_complement.h)
fault("A sum wraps one number late" [[v > V(largest)]] [[v > V(largest + 1)]])
fault("A sum below the least number does not wrap"
  [[select(v < V(-largest), v + V(ones(width)), v)]] [[v]])
