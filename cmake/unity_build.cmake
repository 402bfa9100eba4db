# Unity builds compile several sources as one: a batch reads its headers only once, but a change of
# one source compiles its whole batch. So they suit a single build: ./demo and ./test turn them on.
option(FAIRWAY_UNITY_BUILD "Compile the sources of tool, files, experiments and tests in batches" OFF)

# fairway_unity(<target> <number of sources in a batch>) compiles the target in batches.
function(fairway_unity target batch)
  if(FAIRWAY_UNITY_BUILD)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${batch})
    # GCC treats the sources of a batch as headers, and warns about unnamed namespaces in headers.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
endfunction()

# fairway_runs_once(<target>) compiles tests without loop optimisations, in half the time. Do not
# use it for the tool: the linker may keep its copies of the library's inline functions.
function(fairway_runs_once target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# fairway_seldom_loops(<target>) compiles files, pictures and commands with -O2, because they seldom
# loop. -O1 is too low: the linker may keep their copies of the library's inline functions.
function(fairway_seldom_loops target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O2>)
endfunction()
