# The constant of the last round.
s/c67178f2/c67178f3/
