# A copy of circular and of its model, for tests/benchmark/users.
file(COPY ${project}/model/circular ${project}/model/plane DESTINATION ${copy}/model)
file(COPY ${project}/rtl/circular DESTINATION ${copy}/rtl)
file(GLOB parts ${copy}/model/*/*.cpp)
file(GLOB rtl ${copy}/rtl/circular/*.v)
add_library(circular_copy STATIC ${parts})
target_include_directories(circular_copy PUBLIC ${copy})
target_link_libraries(circular_copy PUBLIC cosim::core)
measured(circular SOURCES ${rtl} MODEL ${copy}/model/circular/circular.h SHAPES "W=16"
  LIBRARIES circular_copy)
target_sources(users_benchmark PRIVATE ${CMAKE_CURRENT_LIST_DIR}/copy.cpp)
target_link_libraries(users_benchmark PRIVATE circular_copy)
