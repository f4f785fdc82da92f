# Mutants of the RTL, planted by yosys and attacked with the testbench's stimuli. Of every design in
# rtl/shipped.txt two shapes: the first, that of the source's example, and the last of 16 bits.
#
#   slice  for the tests: built with everything else; its programs in slice_programs
#   full   for scripts/mutate: the target mutants_full
set(here ${CMAKE_CURRENT_LIST_DIR})
add_executable(mutants_table ${here}/table.cpp)
target_link_libraries(mutants_table PRIVATE engine cold warnings)
add_custom_target(mutants_slice ALL DEPENDS mutants_table)
add_custom_target(mutants_full DEPENDS mutants_table)
set(slice_programs)
set(full_programs)

# add_mutants(SET COUNT PART PARTS DESIGN PARAMETERS...): a program for every PARTS-th of COUNT
# mutants of a design, from number PART on.
function(add_mutants set count part parts DESIGN)
  string(REGEX REPLACE "[ =;]" "" ID "${DESIGN}${ARGN}")
  set(name ${set}_${ID}_${part})
  set(PREFIX Vmutants_${name})
  set(FOLDER ${CMAKE_CURRENT_BINARY_DIR}/${name})
  string(REGEX REPLACE "[A-Z]+=" "" PARAMETERS "${ARGN}")
  string(REPLACE ";" ", " PARAMETERS "${PARAMETERS}")
  set(chosen ${ARGN})
  list(TRANSFORM chosen REPLACE "(.*)=(.*)" " -chparam \\1 \\2")
  list(JOIN chosen "" chosen)
  file(CONFIGURE OUTPUT ${FOLDER}/read.ys CONTENT
    "read_verilog ${DESIGN}/*.v\nhierarchy -check -top ${DESIGN}${chosen}\n")
  cosim_nets_below(${DESIGN})
  configure_file(${PROJECT_SOURCE_DIR}/tb/dut/registers.vlt.in ${FOLDER}/registers.vlt @ONLY)
  file(GLOB rtl CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/rtl/${DESIGN}/*.v)
  add_custom_command(OUTPUT ${FOLDER}/mutants.cpp
    COMMAND ${here}/plant.sh
      ${FOLDER} ${PREFIX} ${DESIGN} ${count} ${part} ${parts} -O3 registers.vlt
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}/rtl
    DEPENDS ${here}/plant.sh ${FOLDER}/read.ys ${FOLDER}/registers.vlt ${rtl} VERBATIM
    COMMENT "Planting mutants in ${DESIGN} ${ARGN}, part ${part}")
  configure_file(${here}/mutants_of.cpp.in ${FOLDER}/mutants_of.cpp @ONLY)
  set_source_files_properties(${FOLDER}/mutants_of.cpp PROPERTIES
    OBJECT_DEPENDS ${FOLDER}/mutants.cpp)

  add_executable(mutants_${name} EXCLUDE_FROM_ALL ${FOLDER}/mutants_of.cpp ${FOLDER}/mutants.cpp)
  # Run for a few thousand clocks a mutant: not compiled for speed.
  target_compile_options(mutants_${name} PRIVATE -O1)
  target_include_directories(mutants_${name} SYSTEM PRIVATE ${FOLDER} ${FOLDER}/verilated)
  target_link_libraries(mutants_${name} PRIVATE mutation proof tb)
  add_dependencies(mutants_${set} mutants_${name})
  set(${set}_programs ${${set}_programs} $<TARGET_FILE:mutants_${name}> PARENT_SCOPE)
endfunction()

file(STRINGS ${PROJECT_SOURCE_DIR}/rtl/shipped.txt shipped REGEX "^[^#]")
set(designs ${shipped})
list(TRANSFORM designs REPLACE " .*" "")
list(REMOVE_DUPLICATES designs)
foreach(design IN LISTS designs)
  set(shapes ${shipped})
  list(FILTER shapes INCLUDE REGEX "^${design} ")
  list(GET shapes 0 example)
  list(FILTER shapes INCLUDE REGEX "^[^=]*=16( |$)")
  list(GET shapes -1 wide)
  separate_arguments(example)
  separate_arguments(wide)
  add_mutants(slice 100 1 1 ${example})
  add_mutants(slice 100 1 1 ${wide})
  foreach(part RANGE 1 4)
    add_mutants(full 4000 ${part} 4 ${example})
    add_mutants(full 2000 ${part} 4 ${wide})
  endforeach()
endforeach()
foreach(set slice full)
  list(JOIN ${set}_programs "\n" programs)
  file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${set}.txt CONTENT "${programs}\n")
endforeach()
