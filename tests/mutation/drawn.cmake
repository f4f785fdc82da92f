# Mutants of the RTL that lanes killed, in Verilated classes: for scripts/mutate --drawn. Of every design in
# rtl/shipped.txt two shapes: the first, that of the source's example, and the last of 16 bits.
set(drawn_of ${CMAKE_CURRENT_LIST_DIR}/drawn_of.cpp.in)

# add_drawn(LIST SHAPE COUNT DRAWN): adds the program drawn_SHAPE_DRAWN, which runs DRAWN of COUNT mutants in
# lockstep, one at a time, to the list.
function(add_drawn list shape count drawn)
  string(REGEX REPLACE "[ =]" "" ID "${shape}")
  set(PREFIX Vdrawn_${ID})
  set(FOLDER ${CMAKE_CURRENT_BINARY_DIR}/drawn/${ID}_${drawn})
  string(REGEX REPLACE " .*" "" DESIGN "${shape}")
  file(GLOB rtl CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/rtl/${DESIGN}/*.v)
  add_custom_command(OUTPUT ${FOLDER}/mutants.cpp
    COMMAND cosim_mutants ${shape} ${count} --draw ${drawn} ${FOLDER}
    COMMAND ${CMAKE_COMMAND} -E rm -rf verilated
    COMMAND ${VERILATOR_BIN} --cc --top-module ${DESIGN} --prefix ${PREFIX} --Mdir verilated
      -Wno-fatal -Wno-lint -Wno-style --x-initial unique --x-assign unique --noassert
      --vpi --public-flat-rw mutants.v
    COMMAND bash -c [[printf '#include "%s"\n' verilated/*.cpp > mutants.cpp]]
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${PREFIX}_ports.h -P ${PROJECT_SOURCE_DIR}/tb/dut/ports.cmake
      verilated/${PREFIX}.h
    WORKING_DIRECTORY ${FOLDER} DEPENDS cosim_mutants ${rtl} VERBATIM
    COMMENT "Drawing mutants of ${shape}")
  configure_file(${drawn_of} ${FOLDER}/drawn_of.cpp @ONLY)
  set_source_files_properties(${FOLDER}/drawn_of.cpp PROPERTIES
    OBJECT_DEPENDS ${FOLDER}/mutants.cpp)
  set(name drawn_${ID}_${drawn})
  add_executable(${name} EXCLUDE_FROM_ALL ${FOLDER}/drawn_of.cpp ${FOLDER}/mutants.cpp)
  set_target_properties(${name} PROPERTIES UNITY_BUILD OFF)
  # Run for a few thousand clocks a mutant: not compiled for speed.
  target_compile_options(${name} PRIVATE -O1)
  target_include_directories(${name} SYSTEM PRIVATE ${FOLDER} ${FOLDER}/verilated)
  target_link_libraries(${name} PRIVATE mutation cosim_machines cosim_benches)
  set(${list} ${${list}} ${name} PARENT_SCOPE)
endfunction()

set(drawn_programs)
foreach(design IN LISTS COSIM_DESIGNS)
  set(shapes ${COSIM_SHIPPED})
  list(FILTER shapes INCLUDE REGEX "^${design} ")
  list(GET shapes 0 example)
  list(FILTER shapes INCLUDE REGEX "^[^=]*=16( |$)")
  list(GET shapes -1 wide)
  add_drawn(drawn_programs "${example}" 4000 200)
  add_drawn(drawn_programs "${wide}" 2000 200)
endforeach()
# And a few of the first for the tests.
list(GET COSIM_SHIPPED 0 first)
set(drawn_slice)
add_drawn(drawn_slice "${first}" 4000 20)
set_target_properties(${drawn_slice} PROPERTIES EXCLUDE_FROM_ALL OFF)
add_custom_target(mutants_drawn DEPENDS ${drawn_programs})
list(TRANSFORM drawn_programs REPLACE "(.+)" "$<TARGET_FILE:\\1>" OUTPUT_VARIABLE programs)
list(JOIN programs "\n" programs)
file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/drawn.txt CONTENT "${programs}\n")
