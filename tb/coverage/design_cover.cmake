# What the sweeps of a design of somebody's own reach: a program for each shape, its RTL Verilated
# with counters, which make it several times slower. Built when the command `cover` asks for it.
include_guard(GLOBAL)
include(${CMAKE_CURRENT_LIST_DIR}/../package/design_on_demand.cmake)

# To be called by cosim_add_design() for a shape, whose variables it uses.
function(cosim_shape_cover)
  set(FOLDER ${CMAKE_CURRENT_BINARY_DIR}/cover/${ID})
  set(COVERED Vcover_${ID})
  file(MAKE_DIRECTORY ${FOLDER})
  add_custom_command(OUTPUT ${FOLDER}/counted.cpp
    COMMAND ${CMAKE_COMMAND} -E rm -rf verilated
    COMMAND ${VERILATOR_BIN} --cc --top-module ${TOP} --prefix ${COVERED} --Mdir verilated
      ${generics} ${options} -Wno-fatal -Wno-lint -Wno-style --x-initial unique --x-assign unique
      --assert --vpi --public-flat-rw
      --coverage-line --coverage-toggle --coverage-user --coverage-max-width 65536 ${rtl}
    COMMAND bash -c [[printf '#include "%s"\n' verilated/*.cpp > counted.cpp]]
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${COVERED}_ports.h -P ${root}/tb/dut/ports.cmake verilated/${COVERED}.h
    WORKING_DIRECTORY ${FOLDER} DEPENDS ${rtl} ${included} VERBATIM
    COMMENT "Counters for ${TITLE}")
  configure_file(${root}/tb/coverage/named_cover_of.cpp.in ${FOLDER}/cover_of.cpp @ONLY)
  cosim_on_demand(cover ${FOLDER}/counted.cpp)
  target_compile_definitions(cover_${ID} PRIVATE COSIM_COVERAGE VM_COVERAGE=1)
endfunction()
