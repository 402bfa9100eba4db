# The target `playground`: build/<preset>/playground.html, the live page without a server. It exists
# where Emscripten is installed (browser_packages in tools/packages.sh).
find_program(FAIRWAY_EMCC em++)
find_program(FAIRWAY_NODE node)
mark_as_advanced(FAIRWAY_EMCC FAIRWAY_NODE)
if(NOT FAIRWAY_EMCC OR NOT FAIRWAY_NODE OR NOT TARGET fairway_io)
  message(STATUS "The target playground is left out; it needs emscripten, nodejs and fairway::io")
  return()
endif()
execute_process(COMMAND em-config EMSCRIPTEN_ROOT OUTPUT_VARIABLE emscripten OUTPUT_STRIP_TRAILING_WHITESPACE
                RESULT_VARIABLE failed)
if(failed OR NOT EXISTS ${emscripten}/cmake/Modules/Platform/Emscripten.cmake)
  message(STATUS "The target playground is left out; em-config does not say where Emscripten's CMake files are")
  return()
endif()
get_target_property(eigen Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
find_path(FAIRWAY_HEADERS tl/expected.hpp)
mark_as_advanced(FAIRWAY_HEADERS)
set(folder ${PROJECT_BINARY_DIR}/playground)
set(FAIRWAY_PLAYGROUND_PAGE ${PROJECT_BINARY_DIR}/playground.html)
add_custom_target(playground
  COMMAND ${CMAKE_COMMAND} -S ${PROJECT_SOURCE_DIR}/apps/playground -B ${folder} -G ${CMAKE_GENERATOR} --log-level=WARNING
          -DCMAKE_TOOLCHAIN_FILE=${emscripten}/cmake/Modules/Platform/Emscripten.cmake -DCMAKE_BUILD_TYPE=Release
          -DFAIRWAY_VERSION=${PROJECT_VERSION} -DFAIRWAY_EIGEN=${eigen} -DFAIRWAY_HEADERS=${FAIRWAY_HEADERS}
          -DFAIRWAY_EMSCRIPTEN=${emscripten} -DFAIRWAY_NODE=${FAIRWAY_NODE}
          -DFAIRWAY_PLAYGROUND_PAGE=${FAIRWAY_PLAYGROUND_PAGE}
  # Emscripten's own scripts need Debian's node packages, which another Node does not look for.
  COMMAND ${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs ${CMAKE_COMMAND} --build ${folder}
  BYPRODUCTS ${FAIRWAY_PLAYGROUND_PAGE} USES_TERMINAL VERBATIM)
