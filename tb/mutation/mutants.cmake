# Mutants of the RTL, planted by yosys and attacked with the testbench's stimuli. Of every design in
# rtl/shipped.txt two shapes: the first, that of the source's example, and the last of 16 bits.
#
#   mutants  attacks those of any shape that is built
#   slice    for the tests; its programs, `mutants` on one shape, in slice_programs
#   full     for scripts/mutate
#   all      for scripts/mutate --all: every mutant there is, and of the shapes of 32 bits too
#   drawn    for scripts/mutate --drawn: some that lanes killed, in Verilated classes
set(here ${CMAKE_CURRENT_LIST_DIR})
add_executable(mutants_table ${here}/table.cpp)
target_link_libraries(mutants_table PRIVATE engine cold warnings)

# A program for some mutants of a shape.
function(add_mutants set count shape)
  string(REGEX REPLACE "[ =]" "" ID "${shape}")
  set(program ${CMAKE_CURRENT_BINARY_DIR}/mutants_${set}_${ID})
  file(GENERATE OUTPUT ${program}
    CONTENT "#!/bin/sh\nexec '$<TARGET_FILE:cosim_mutants>' '${shape}' ${count} \"$@\"\n"
    FILE_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
      WORLD_EXECUTE)
  set(${set}_programs ${${set}_programs} ${program} PARENT_SCOPE)
endfunction()

# add_drawn(SHAPE COUNT DRAWN): the program drawn_SHAPE_DRAWN, which runs DRAWN of COUNT mutants in lockstep,
# one at a time.
function(add_drawn shape count drawn)
  string(REGEX REPLACE "[ =]" "" ID "${shape}")
  set(PREFIX Vdrawn_${ID})
  set(FOLDER ${CMAKE_CURRENT_BINARY_DIR}/drawn/${ID}_${drawn})
  string(REGEX REPLACE " .*" "" DESIGN "${shape}")
  file(GLOB rtl CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/rtl/${DESIGN}/*.v)
  add_custom_command(OUTPUT ${FOLDER}/mutants.cpp
    COMMAND cosim_mutants ${shape} ${count} --draw ${drawn} ${FOLDER}
    COMMAND ${here}/verilate.sh ${FOLDER} ${PREFIX} ${DESIGN} --vpi --public-flat-rw
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${FOLDER}/${PREFIX}_ports.h -P ${PROJECT_SOURCE_DIR}/tb/dut/ports.cmake
      ${FOLDER}/verilated/${PREFIX}.h
    DEPENDS cosim_mutants ${here}/verilate.sh ${rtl} VERBATIM
    COMMENT "Drawing mutants of ${shape}")
  configure_file(${here}/drawn_of.cpp.in ${FOLDER}/drawn_of.cpp @ONLY)
  set_source_files_properties(${FOLDER}/drawn_of.cpp PROPERTIES
    OBJECT_DEPENDS ${FOLDER}/mutants.cpp)
  set(name drawn_${ID}_${drawn})
  add_executable(${name} EXCLUDE_FROM_ALL ${FOLDER}/drawn_of.cpp ${FOLDER}/mutants.cpp)
  set_target_properties(${name} PROPERTIES UNITY_BUILD OFF)
  # Run for a few thousand clocks a mutant: not compiled for speed.
  target_compile_options(${name} PRIVATE -O1)
  target_include_directories(${name} SYSTEM PRIVATE ${FOLDER} ${FOLDER}/verilated)
  target_link_libraries(${name} PRIVATE mutation cosim_machines cosim_benches)
endfunction()

set(drawn_programs)
foreach(design IN LISTS COSIM_DESIGNS)
  set(shapes ${COSIM_SHIPPED})
  list(FILTER shapes INCLUDE REGEX "^${design} ")
  list(GET shapes 0 example)
  list(FILTER shapes INCLUDE REGEX "^[^=]*=16( |$)")
  list(GET shapes -1 wide)
  add_mutants(slice 100 "${example}")
  add_mutants(slice 100 "${wide}")
  add_mutants(full 4000 "${example}")
  add_mutants(full 2000 "${wide}")
  set(widest ${COSIM_SHIPPED})
  list(FILTER widest INCLUDE REGEX "^${design} [^=]*=32( |$)")
  foreach(shape "${example}" "${wide}" ${widest})
    add_mutants(all 65535 "${shape}")
  endforeach()
  add_drawn("${example}" 4000 200)
  add_drawn("${wide}" 2000 200)
  foreach(shape "${example}" "${wide}")
    string(REGEX REPLACE "[ =]" "" ID "${shape}")
    list(APPEND drawn_programs drawn_${ID}_200)
  endforeach()
endforeach()
# And a few of the first for the tests.
list(GET COSIM_SHIPPED 0 first)
add_drawn("${first}" 4000 20)
string(REGEX REPLACE "[ =]" "" ID "${first}")
set(drawn_slice drawn_${ID}_20)
set_target_properties(${drawn_slice} PROPERTIES EXCLUDE_FROM_ALL OFF)
add_custom_target(mutants_drawn DEPENDS ${drawn_programs})
set(programs ${drawn_programs})
list(TRANSFORM programs REPLACE "(.+)" "$<TARGET_FILE:\\1>")
list(JOIN programs "\n" programs)
file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/drawn.txt CONTENT "${programs}\n")
foreach(set slice full all)
  add_custom_target(mutants_${set} DEPENDS cosim_mutants mutants_table)
  list(JOIN ${set}_programs "\n" programs)
  file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${set}.txt CONTENT "${programs}\n")
endforeach()
