# What the sweeps of a design of somebody's own reach: a program for each shape, its RTL Verilated
# with counters, which make it several times slower. Built when the command `cover` asks for it.
include_guard(GLOBAL)

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
    WORKING_DIRECTORY ${FOLDER} DEPENDS ${rtl} ${included} VERBATIM
    COMMENT "Counters for ${TITLE}")
  configure_file(${root}/tb/coverage/named_cover_of.cpp.in ${FOLDER}/cover_of.cpp @ONLY)
  set_source_files_properties(${FOLDER}/cover_of.cpp PROPERTIES
    OBJECT_DEPENDS ${FOLDER}/counted.cpp)

  add_executable(cover_${ID} EXCLUDE_FROM_ALL ${FOLDER}/cover_of.cpp ${FOLDER}/counted.cpp)
  set_target_properties(cover_${ID} PROPERTIES
    UNITY_BUILD OFF RUNTIME_OUTPUT_DIRECTORY ${FOLDER})
  target_compile_features(cover_${ID} PRIVATE cxx_std_20)
  target_compile_definitions(cover_${ID} PRIVATE
    COSIM_COVERAGE COSIM_COVERAGE_OF_CASES VM_COVERAGE=1)
  target_compile_options(cover_${ID} PRIVATE -O1)
  target_include_directories(cover_${ID} SYSTEM PRIVATE ${FOLDER} ${FOLDER}/verilated)
  target_link_libraries(cover_${ID} PRIVATE cosim::stream cosim::dut cosim::runtime)
  set_property(GLOBAL APPEND PROPERTY COSIM_ON_DEMAND
    "    registry.cover({\"${TITLE}\", \"cover_${ID}\", \"${FOLDER}\"})\;\n")
endfunction()
