add_view_test(dda "" ${view} $<TARGET_FILE:cosim> dda --circle 12)
