# In model/circular/: the cycle model, its oracle, and the device outside of SU 1665343; and in the
# numbers in ones' complement that it is made of.

faults_in(circular/circular.h)
fault("CT8 falls by one on a diagonal step" [[ct8 = ct8 - mux(diagonal, 2, 1);]] [[ct8 = ct8 - 1;]])
fault("CT7 does not wrap" [[ct7 = mux(t16, ct7 - 1, ct7 + 1);]]
  [[static_cast<Int<W + 1>&>(ct7) = mux(t16, ct7 - 1, ct7 + 1);]])
fault("A negative CT7 counts as a positive one" [[gain = -(twice7 + (ct7 >= 0));]]
  [[gain = -twice7 - 1;]])
fault("A straight step of sector 1 adds -2Y + 1" [[gain = -(twice7 + (ct7 >= 0));]]
  [[gain = -twice7 + 1;]])
fault("A negative CT8 counts as a positive one in sector 2" [[gain = twice8 - (ct8 < 0);]]
  [[gain = twice8;]])
fault("A diagonal step of sector 1 adds 2(X - Y) - 2" [[gain = twice8 + 1;]] [[gain = twice8;]])
fault("A straight step of sector 2 adds 2X - 3" [[gain = twice7 + 1;]] [[gain = twice7 - 1;]])
fault("A diagonal step to X = Y adds nothing" [[f = f + (gain << 2);]]
  [[if (!(diagonal && !t16 && ct8 == -1)) f = f + (gain << 2);]])
fault("The variants are taken for each other" [=[ct8[0]]=] [=[!ct8[0]]=])
fault("Variant -2 finds X at Y" [[ct7 - !level]] [[Int<W + 2>(ct7)]])
fault("The correction leaves CT7 at X" [[ct7 = x - 1;]] [[ct7 = x;]])
fault("The correction leaves CT8 at 0 for both variants" [[ct8 = mux(level, 0, -1);]] [[ct8 = 0;]])
fault("Variant -2 adds 2X" [[f = f + ((x + x + !level) << 2);]] [[f = f + ((x + x) << 2);]])
fault("A start needs a load" [[t4 = in.start;]] [[t4 = in.start && in.load;]])
fault("Sector 2 is forgotten before the start" [[t16 = t16 || in.sector2;]] [[t16 = in.sector2;]])
fault("F is loaded with the fraction .00" [[f = (in.f << 2) + 3;]] [[f = in.f << 2;]])
fault("A second load leaves CT8" [[ct8 = in.ct8.number();]]
  [[if (ct8 == 0) ct8 = in.ct8.number();]])
fault("A negative CT7 ends no arc in sector 1" [[t4 && ct7 < 0]] [[t4 && ct7 < 0 && t16]])
fault("The sector changes at X - Y = 1" [[t4 && !t16 && ct8 < 0]] [[t4 && !t16 && ct8 < 1]])
fault("A step comes with stop"
  [[t4 && !finish && !correct && !in.stop]] [[t4 && !finish && !correct]])
fault("No step comes with reset"
  [[step && (diagonal || !t16)]] [[step && (diagonal || !t16) && !in.rst]])
fault("The sign of F is taken the wrong way round" [[f > 0]] [[!(f > 0)]])
fault("A straight step of sector 2 is none" [[step && (diagonal || t16)]] [[step && diagonal]])
fault("Stop ends nothing" [[in.rst || in.stop || finish]] [[in.rst || finish]])
fault("An arc that runs is loaded" [[pass_into_sector2();]] [[wait(in);]])
fault("The host stops an arc a step late" [[steps >= job.count]] [[steps > job.count]])
fault("The host sends F in ones' complement" [[in.f = job.f;]]
  [[in.f = OnesComplement<W + 2>(job.f).code();]])
fault("The host starts every arc in sector 1" [[in.sector2 = job.sector2;]] [[in.sector2 = 0;]])
fault("The check of jobs does not look whether the circle is nearer"
  [[past || !must || !nearest]] [[past || !must]])
fault("The check of jobs takes a point on the edge for one beyond"
  [[excess >= -resting]] [[excess > -resting]])

faults_in(clocked/design_of.h)
fault("The zero of F is +0" [=[State<V>::Table::has_minus_zero[i] ? all : V(0)]=] [=[V(0)]=])

faults_in(clocked/fields.h)
fault("A sum wraps one number late" [[v > most]] [[v > most + 1]])
fault("A sum below the least number does not wrap"
  [[mux(v < -most, -1, 0)]] [[0]])

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
