# Warnings for our own targets. They are linked PRIVATE through $<BUILD_INTERFACE:...>, so users
# never see them.
add_library(fairway_warnings INTERFACE)
target_compile_options(fairway_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wdouble-promotion
  -Wold-style-cast -Wnon-virtual-dtor -Woverloaded-virtual -Wcast-align -Wformat=2
  -Wswitch-enum -Wextra-semi
  -Wno-missing-field-initializers  # designated initialisers name only the fields that they set
  $<$<CXX_COMPILER_ID:GNU>:-Wuseless-cast>
  # Inner loops join two comparisons by & on purpose, because this costs no branch.
  $<$<CXX_COMPILER_ID:Clang>:-Wno-bitwise-instead-of-logical>)
