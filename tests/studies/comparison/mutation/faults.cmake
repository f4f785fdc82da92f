# In model/prior_art/: what the sources are compared with.

fault("A line begins as if half a step were made" prior_art/bresenham.h
  [[2 * line.minor - line.major]] [[2 * line.minor]])
fault("A minor step is made at half already" prior_art/bresenham.h
  [[error > 0]] [[error >= 0]])
fault("A minor step is worth half of one" prior_art/bresenham.h
  [[error -= 2 * line.major;]] [[error -= line.major;]])

fault("The octant begins a half step further out" prior_art/midpoint_circle.h
  [[at.x * at.x - at.x + 1]] [[at.x * at.x + 1]])
fault("A middle a quarter outside is inside" prior_art/midpoint_circle.h
  [[decision >= 0]] [[decision > 0]])
fault("A step of X does not count" prior_art/midpoint_circle.h
  [[decision -= 2 * at.x;]] [[decision -= 0;]])
fault("The octant leaves its last point out" prior_art/midpoint_circle.h
  [[at.x >= at.y]] [[at.x > at.y]])
fault("An arc begins left of its start" prior_art/midpoint_circle.h
  [[p.y < arc.from.y || p.x > arc.from.x]] [[p.x >= arc.from.x]])
fault("An arc has its row beyond the end" prior_art/midpoint_circle.h
  [[p.y > arc.to.y || p.x < arc.to.x]] [[p.y > arc.to.y + 1 || p.x < arc.to.x]])
fault("A point of both octants comes twice" prior_art/midpoint_circle.h
  [[!(p == points.back())]] [[true]])

fault("A bit comes twice as often" prior_art/rate_multiplier.h
  [[positions / 2 / lowest_one]] [[positions / lowest_one]])
fault("The minor axis has its bits in the other order" prior_art/rate_multiplier.h
  [[(line.minor & bit) != 0]] [[(line.minor & lowest_one) != 0]])
fault("The last position is left out" prior_art/rate_multiplier.h
  [[q <= positions]] [[q < positions]])

fault("An arc's start is taken to be on the X axis" prior_art/single_axis_circle.h
  [[square(arc.from.x) + square(arc.from.y)]] [[square(arc.from.x)]])
fault("A point on the circle is inside" prior_art/single_axis_circle.h
  [[value >= 0]] [[value > 0]])
fault("Y goes beyond its end" prior_art/single_axis_circle.h
  [[at.y >= arc.to.y]] [[at.y > arc.to.y]])
fault("A step of X adds the square of the point before" prior_art/single_axis_circle.h
  [[value -= 2 * at.x - 1;]] [[value -= 2 * at.x + 1;]])

fault("The formula as it is printed, a row late" prior_art/su875343.h
  [[square(at.y + 1)]] [[square(at.y)]])
fault("A diagonal does not change the sum" prior_art/su875343.h
  [[value -= 2 * at.x;]] [[value -= 0;]])
fault("A middle a quarter outside is inside for SU 875343" prior_art/su875343.h
  [[value >= 0]] [[value > 0]])
fault("An arc that ends before 45 degrees goes on to the X of its end" prior_art/su875343.h
  [[before ? at.y < arc.to.y : at.x > arc.to.x]] [[at.x > arc.to.x]])
