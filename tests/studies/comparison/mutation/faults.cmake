# In model/prior_art/: what the sources are compared with.

faults_in(prior_art/bresenham.h)
fault("A line begins as if half a step were made"
  [[2 * line.minor - line.major]] [[2 * line.minor]])
fault("A minor step is made at half already" [[error > 0]] [[error >= 0]])
fault("A minor step is worth half of one" [[error -= 2 * line.major;]] [[error -= line.major;]])

faults_in(prior_art/midpoint_circle.h)
fault("The octant begins a half step further out" [[at.x * at.x - at.x + 1]] [[at.x * at.x + 1]])
fault("A middle a quarter outside is inside" [[decision >= 0]] [[decision > 0]])
fault("A step of X does not count" [[decision -= 2 * at.x;]] [[decision -= 0;]])
fault("The octant leaves its last point out" [[at.x >= at.y]] [[at.x > at.y]])
fault("An arc begins left of its start"
  [[p.y < arc.from.y || p.x > arc.from.x]] [[p.x >= arc.from.x]])
fault("An arc has its row beyond the end"
  [[p.y > arc.to.y || p.x < arc.to.x]] [[p.y > arc.to.y + 1 || p.x < arc.to.x]])
fault("A point of both octants comes twice" [[!(p == points.back())]] [[true]])

faults_in(prior_art/rate_multiplier.h)
fault("A bit comes twice as often" [[positions / 2 / lowest_one]] [[positions / lowest_one]])
fault("The minor axis has its bits in the other order"
  [[(line.minor & bit) != 0]] [[(line.minor & lowest_one) != 0]])
fault("The last position is left out" [[q <= positions]] [[q < positions]])

faults_in(prior_art/single_axis_circle.h)
fault("An arc's start is taken to be on the X axis"
  [[square(arc.from.x) + square(arc.from.y)]] [[square(arc.from.x)]])
fault("A point on the circle is inside" [[value >= 0]] [[value > 0]])
fault("Y goes beyond its end" [[at.y >= arc.to.y]] [[at.y > arc.to.y]])
fault("A step of X adds the square of the point before"
  [[value -= 2 * at.x - 1;]] [[value -= 2 * at.x + 1;]])

faults_in(prior_art/su875343.h)
fault("The formula as it is printed, a row late" [[square(at.y + 1)]] [[square(at.y)]])
fault("A diagonal does not change the sum" [[value -= 2 * at.x;]] [[value -= 0;]])
fault("A middle a quarter outside is inside for SU 875343" [[value >= 0]] [[value > 0]])
fault("An arc that ends before 45 degrees goes on to the X of its end"
  [[before ? at.y < arc.to.y : at.x > arc.to.x]] [[at.x > arc.to.x]])
