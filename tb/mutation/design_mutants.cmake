# The mutants of a design of somebody's own: a program for each shape, built when the command `mutate`
# asks for it. That command writes what plant.sh is to be given.
include_guard(GLOBAL)
include(${CMAKE_CURRENT_LIST_DIR}/../package/design_on_demand.cmake)

# To be called by cosim_add_design() for a shape, whose variables it uses.
function(cosim_shape_mutants)
  set(FOLDER ${CMAKE_CURRENT_BINARY_DIR}/mutants/${ID})
  set(MUTANTS Vmutants_${ID})
  set(given ${FOLDER}/read.ys ${FOLDER}/kept.txt ${FOLDER}/count.txt)
  add_custom_command(OUTPUT ${FOLDER}/mutants.cpp
    COMMAND bash ${root}/tb/mutation/plant.sh
      ${FOLDER} ${MUTANTS} ${TOP} ${FOLDER}/count.txt --vpi --public-flat-rw
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${FOLDER}/${MUTANTS}_ports.h -P ${root}/tb/dut/ports.cmake
      ${FOLDER}/verilated/${MUTANTS}.h
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
    DEPENDS ${root}/tb/mutation/plant.sh ${root}/tb/mutation/verilate.sh ${given} ${rtl} ${included} VERBATIM
    COMMENT "Planting mutants in ${TITLE}")
  configure_file(${root}/tb/mutation/named_mutants_of.cpp.in ${FOLDER}/mutants_of.cpp @ONLY)
  cosim_on_demand(mutants ${FOLDER}/mutants.cpp cosim::mutation)
endfunction()
