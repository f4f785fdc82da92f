# The mutants of a design of somebody's own: a program for each shape, built when the command `mutate`
# asks for it. That command writes what plant.sh is to be given.
include_guard(GLOBAL)

# To be called by cosim_add_design() for a shape, whose variables it uses.
function(cosim_shape_mutants)
  set(FOLDER ${CMAKE_CURRENT_BINARY_DIR}/mutants/${ID})
  set(MUTANTS Vmutants_${ID})
  set(given ${FOLDER}/read.ys ${FOLDER}/kept.txt ${FOLDER}/count.txt)
  add_custom_command(OUTPUT ${FOLDER}/mutants.cpp
    COMMAND bash ${root}/tb/mutation/plant.sh
      ${FOLDER} ${MUTANTS} ${TOP} ${FOLDER}/count.txt 1 1 --vpi --public-flat-rw
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}
    DEPENDS ${root}/tb/mutation/plant.sh ${given} ${rtl} ${included} VERBATIM
    COMMENT "Planting mutants in ${TITLE}")
  configure_file(${root}/tb/mutation/named_mutants_of.cpp.in ${FOLDER}/mutants_of.cpp @ONLY)
  set_source_files_properties(${FOLDER}/mutants_of.cpp PROPERTIES
    OBJECT_DEPENDS ${FOLDER}/mutants.cpp)

  add_executable(mutants_${ID} EXCLUDE_FROM_ALL ${FOLDER}/mutants_of.cpp ${FOLDER}/mutants.cpp)
  set_target_properties(mutants_${ID} PROPERTIES
    UNITY_BUILD OFF RUNTIME_OUTPUT_DIRECTORY ${FOLDER})
  target_compile_features(mutants_${ID} PRIVATE cxx_std_20)
  # Run for a few thousand clocks a mutant: not compiled for speed.
  target_compile_options(mutants_${ID} PRIVATE -O1)
  target_include_directories(mutants_${ID} SYSTEM PRIVATE ${FOLDER} ${FOLDER}/verilated)
  target_link_libraries(mutants_${ID} PRIVATE
    cosim::mutation cosim::stream cosim::dut cosim::runtime)
  set_property(GLOBAL APPEND PROPERTY COSIM_ON_DEMAND
    "    registry.mutants({\"${TITLE}\", \"mutants_${ID}\", \"${FOLDER}\"})\;\n")
endfunction()
