# Precompiled headers halve a clean build, and make every later one start with a longer step. So they
# are for those who build once: ./demo and ./test turn them on.
option(FAIRWAY_PRECOMPILED_HEADERS "Precompile the headers that most sources include" OFF)

set(FAIRWAY_STANDARD_HEADERS <algorithm> <array> <cmath> <functional> <memory> <optional> <span> <string> <vector>)

# fairway_precompile(<target> <header>...): these and the standard library's.
function(fairway_precompile target)
  # A batch of a unity build reads its headers once anyway: faster than loading 100 MB.
  get_target_property(in_batches ${target} UNITY_BUILD)
  if(FAIRWAY_PRECOMPILED_HEADERS AND NOT in_batches)
    target_precompile_headers(${target} PRIVATE ${FAIRWAY_STANDARD_HEADERS} ${ARGN})
  endif()
endfunction()
