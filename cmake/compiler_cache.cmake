# Compiles through ccache if it is installed: a second build of the same sources takes seconds.
option(FAIRWAY_COMPILER_CACHE "Compile through ccache if it is installed" ${PROJECT_IS_TOP_LEVEL})
find_program(FAIRWAY_CCACHE ccache)
mark_as_advanced(FAIRWAY_CCACHE)
if(FAIRWAY_COMPILER_CACHE AND FAIRWAY_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Precompiled headers need the sloppiness; the base folder lets other clones share the cache.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
      CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
      CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${FAIRWAY_CCACHE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-fpch-preprocess>)
  endif()
endif()
