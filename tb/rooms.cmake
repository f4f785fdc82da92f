# Finds what there is to build, so that nothing lists it:
#
#   COSIM_DESIGNS  the designs of rtl/shipped.txt, in its order; each has folders of its name in rtl,
#                  model and tb/designs, and may have one in tests/designs
#   COSIM_STUDIES  the folders of tb/studies by name, without those that need what is not there
#   COSIM_MODELS   the folders of model/ that these use
#
# A study says in tb/studies/NAME/study.cmake what it needs: STUDY_DESIGNS, STUDY_STUDIES and
# STUDY_MODELS, the folders of model/ that it brings.
set(COSIM_SHAPES rtl/shipped.txt CACHE STRING "The file of the parameter sets to build")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${COSIM_SHAPES})
file(STRINGS ${PROJECT_SOURCE_DIR}/${COSIM_SHAPES} COSIM_SHIPPED REGEX "^[^#]")
set(COSIM_DESIGNS ${COSIM_SHIPPED})
list(TRANSFORM COSIM_DESIGNS REPLACE " .*" "")
list(REMOVE_DUPLICATES COSIM_DESIGNS)
foreach(design IN LISTS COSIM_DESIGNS)
  foreach(folder rtl model tb/designs)
    if(NOT IS_DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}/${design})
      message(FATAL_ERROR "rtl/shipped.txt: there is no folder ${folder}/${design}")
    endif()
  endforeach()
endforeach()
file(GLOB folders CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/tb/designs
  ${PROJECT_SOURCE_DIR}/tb/designs/*)
foreach(design IN LISTS folders)
  if(NOT design IN_LIST COSIM_DESIGNS)
    message(STATUS "design ${design} left out: no line in rtl/shipped.txt")
  endif()
endforeach()

set(COSIM_MODELS core ${COSIM_DESIGNS})
file(GLOB specs CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tb/studies/*/study.cmake)
set(COSIM_STUDIES)
foreach(spec IN LISTS specs)
  cmake_path(GET spec PARENT_PATH folder)
  cmake_path(GET folder FILENAME study)
  list(APPEND COSIM_STUDIES ${study})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${spec})
endforeach()
list(SORT COSIM_STUDIES)

# One that is left out may take another with it.
set(again ON)
while(again)
  set(again OFF)
  foreach(study IN LISTS COSIM_STUDIES)
    set(STUDY_DESIGNS)
    set(STUDY_STUDIES)
    set(STUDY_MODELS)
    include(${PROJECT_SOURCE_DIR}/tb/studies/${study}/study.cmake)
    set(missing ${STUDY_DESIGNS})
    list(REMOVE_ITEM missing ${COSIM_DESIGNS})
    list(TRANSFORM missing PREPEND "design ")
    set(studies ${STUDY_STUDIES})
    list(REMOVE_ITEM studies ${COSIM_STUDIES})
    list(TRANSFORM studies PREPEND "study ")
    list(APPEND missing ${studies})
    if(missing)
      list(JOIN missing ", no " missing)
      message(STATUS "study ${study} left out: no ${missing}")
      list(REMOVE_ITEM COSIM_STUDIES ${study})
      set(again ON)
      break()
    endif()
  endforeach()
endwhile()
foreach(study IN LISTS COSIM_STUDIES)
  set(STUDY_MODELS)
  include(${PROJECT_SOURCE_DIR}/tb/studies/${study}/study.cmake)
  list(APPEND COSIM_MODELS ${STUDY_MODELS})
endforeach()
list(REMOVE_DUPLICATES COSIM_MODELS)

# room_sources(VARIABLE FOLDER PATTERN): the sources of that pattern in the folders of the designs and
# of the studies in FOLDER, tb or tests.
function(room_sources variable folder pattern)
  set(all)
  foreach(kind designs studies)
    string(TOUPPER COSIM_${kind} names)
    foreach(name IN LISTS ${names})
      file(GLOB sources CONFIGURE_DEPENDS
        ${PROJECT_SOURCE_DIR}/${folder}/${kind}/${name}/${pattern})
      list(APPEND all ${sources})
    endforeach()
  endforeach()
  set(${variable} ${all} PARENT_SCOPE)
endfunction()
