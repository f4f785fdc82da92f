# Full, and one goes: room for another?
s/in_ready = count != DEPTH;/in_ready = count != DEPTH | out_ready \& head == 0;/
