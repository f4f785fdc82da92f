add_view_test(line "" ${view} $<TARGET_FILE:cosim> line --major 27 --minor 9)
# The word that loses the carry is the line's 1024th.
add_view_test(linear_deep linear/deep/tick_carry ${view} $<TARGET_FILE:cosim_variant>
  line --major 8192 --minor 4097)
