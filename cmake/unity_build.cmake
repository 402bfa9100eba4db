# Unity builds compile several sources as one: what their headers cost is paid once per batch, and a change
# of one source compiles its whole batch. So they are for those who build once: ./demo and ./test turn
# them on.
option(FAIRWAY_UNITY_BUILD "Compile the sources of tool, files, experiments and tests in batches" OFF)

# fairway_unity(<target> <number of sources in a batch>)
function(fairway_unity target batch)
  if(FAIRWAY_UNITY_BUILD)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${batch})
    # GCC takes the sources of a batch for headers, in which an unnamed namespace would be a mistake.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
endfunction()

# fairway_runs_once(<target>): tests compile in half the time without the optimisations that loops need. Not
# for the tool: inline functions of the library that it compiles too may be those that are linked.
function(fairway_runs_once target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# fairway_seldom_loops(<target>): files, pictures and commands spend their time elsewhere; -O2 compiles them
# faster. Not -O1: inline functions of the library that they compile too may be those that are linked.
function(fairway_seldom_loops target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O2>)
endfunction()
