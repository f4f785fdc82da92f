# What the sweeps of a design of somebody's own reach: a program for each shape, its RTL Verilated
# with counters, which make it several times slower. Built when the command `cover` asks for it.
include_guard(GLOBAL)

# The program cover_ID, of which Registry::covers() knows. To be called by cosim_add_design() for a shape,
# whose variables it uses.
function(cosim_shape_cover)
  set(FOLDER ${CMAKE_CURRENT_BINARY_DIR}/cover/${ID})
  set(COVERED Vcover_${ID})
  file(MAKE_DIRECTORY ${FOLDER})
  add_custom_command(OUTPUT ${FOLDER}/counted.cpp
    COMMAND ${CMAKE_COMMAND} -E rm -rf verilated
    COMMAND ${VERILATOR_BIN} --cc --top-module ${TOP} --prefix ${COVERED} --Mdir verilated
      ${generics} ${options} ${rtl_of_unrolled} -Wno-fatal -Wno-lint -Wno-style --no-timing
      --x-initial unique --x-assign unique --assert --vpi --public-flat-rw
      --coverage-line --coverage-toggle --coverage-user --coverage-max-width 65536 ${rtl}
    COMMAND bash -c [[printf '#include "%s"\n' verilated/*.cpp > counted.cpp]]
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${COVERED}_ports.h -P ${root}/tb/dut/ports.cmake verilated/${COVERED}.h
    WORKING_DIRECTORY ${FOLDER} DEPENDS ${rtl} ${included} VERBATIM
    COMMENT "Counters for ${TITLE}")
  set(declared_dump "")
  set(counted "")
  string(REGEX MATCH "^[0-9]+" version "${CMAKE_CXX_COMPILER_VERSION}")
  get_filename_component(beside "${CMAKE_CXX_COMPILER}" DIRECTORY)
  find_program(COSIM_GCOV NAMES gcov-${version} gcov HINTS "${beside}")
  mark_as_advanced(COSIM_GCOV)
  if(NOT has_clock AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND COSIM_GCOV)
    # Its model is any C++, whose lines the compiler counts.
    set(notes ${FOLDER}/model.gcno)
    set(options_of_model --coverage -fprofile-note=${notes})
    set(declared_dump "extern \"C\" void __gcov_dump();\n")
    set(counted "__gcov_dump, \"${COSIM_GCOV}\", \"${notes}\", \"${CMAKE_CURRENT_SOURCE_DIR}\", \"${CMAKE_BINARY_DIR}\"")
  endif()
  configure_file(${root}/tb/package/named_cover_of.cpp.in ${FOLDER}/cover_of.cpp @ONLY)
  set_source_files_properties(${FOLDER}/cover_of.cpp PROPERTIES OBJECT_DEPENDS ${FOLDER}/counted.cpp)
  set(program cover_${ID})
  add_executable(${program} EXCLUDE_FROM_ALL ${FOLDER}/cover_of.cpp ${FOLDER}/counted.cpp)
  set_target_properties(${program} PROPERTIES
    UNITY_BUILD OFF RUNTIME_OUTPUT_DIRECTORY ${FOLDER})
  # Run for a few thousand clocks: not compiled for speed.
  target_compile_options(${program} PRIVATE -O1)
  if(declared_dump)
    set_source_files_properties(${FOLDER}/cover_of.cpp PROPERTIES COMPILE_OPTIONS "${options_of_model}")
    target_link_options(${program} PRIVATE --coverage)
  endif()
  target_compile_definitions(${program} PRIVATE COSIM_COVERAGE VM_COVERAGE=1)
  target_include_directories(${program} SYSTEM PRIVATE
    ${FOLDER} ${FOLDER}/verilated ${CMAKE_CURRENT_BINARY_DIR})
  target_link_libraries(${program} PRIVATE ${D_LIBRARIES} cosim::stream cosim::dut
    cosim::runtime_parts cosim::runtime)
  if(has_clock)  # the ways through it
    add_dependencies(${program} ${NAME}_exported)
  endif()
  set_property(GLOBAL APPEND PROPERTY COSIM_ON_DEMAND
    "    {BuiltOnDemand::Kind::cover, \"${TITLE}\", \"${program}\", \"${FOLDER}\"},\n")
endfunction()
