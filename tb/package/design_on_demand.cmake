# A program for one shape of a design of somebody's own that is built when a command asks for it.
include_guard(GLOBAL)

# cosim_on_demand(KIND FILE LIBRARY...): the program KIND_ID in the folder FOLDER, of KIND_of.cpp there
# and of FILE, which is Verilated into its folder verilated, and Registry::KIND knows of it. For a
# function that cosim_add_design() calls for a shape: it uses the shape's variables, and FOLDER.
function(cosim_on_demand KIND FILE)
  set_source_files_properties(${FOLDER}/${KIND}_of.cpp PROPERTIES OBJECT_DEPENDS ${FILE})
  set(program ${KIND}_${ID})
  add_executable(${program} EXCLUDE_FROM_ALL ${FOLDER}/${KIND}_of.cpp ${FILE})
  set_target_properties(${program} PROPERTIES
    UNITY_BUILD OFF RUNTIME_OUTPUT_DIRECTORY ${FOLDER})
  target_compile_features(${program} PRIVATE cxx_std_20)
  # Run for a few thousand clocks: not compiled for speed.
  target_compile_options(${program} PRIVATE -O1)
  target_include_directories(${program} SYSTEM PRIVATE
    ${FOLDER} ${FOLDER}/verilated ${CMAKE_CURRENT_BINARY_DIR})
  target_link_libraries(${program} PRIVATE ${ARGN} ${D_LIBRARIES} cosim::stream cosim::dut
    cosim::runtime_parts cosim::runtime)
  set_property(GLOBAL APPEND PROPERTY COSIM_ON_DEMAND
    "    {BuiltOnDemand::Kind::${KIND}, \"${TITLE}\", \"${program}\", \"${FOLDER}\"},\n")
endfunction()
