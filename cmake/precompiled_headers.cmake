# Precompiled headers halve a clean build, and make every later one start with a longer step. So they
# are for those who build once: ./demo and ./test turn them on.
option(FAIRWAY_PRECOMPILED_HEADERS "Precompile the headers that most sources include" OFF)

set(FAIRWAY_STANDARD_HEADERS <algorithm> <array> <cmath> <functional> <memory> <optional> <span> <string> <vector>)

# fairway_precompile(<target> <header>...): these and the standard library's.
function(fairway_precompile target)
  if(FAIRWAY_PRECOMPILED_HEADERS)
    target_precompile_headers(${target} PRIVATE ${FAIRWAY_STANDARD_HEADERS} ${ARGN})
  endif()
endfunction()
