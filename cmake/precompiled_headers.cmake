# Precompiled headers halve the time of a clean build, but add a longer first step to every later
# one. So they suit a single build: ./demo and ./test turn them on.
option(FAIRWAY_PRECOMPILED_HEADERS "Precompile the headers that most sources include" OFF)

set(FAIRWAY_STANDARD_HEADERS <algorithm> <array> <cmath> <functional> <memory> <optional> <span> <string> <vector>)

# fairway_precompile(<target> <header>...) precompiles these and the standard library's headers.
function(fairway_precompile target)
  # A batch of a unity build reads its headers once anyway, which is faster than loading 100 MB.
  get_target_property(in_batches ${target} UNITY_BUILD)
  if(FAIRWAY_PRECOMPILED_HEADERS AND NOT in_batches)
    target_precompile_headers(${target} PRIVATE ${FAIRWAY_STANDARD_HEADERS} ${ARGN})
  endif()
endfunction()
