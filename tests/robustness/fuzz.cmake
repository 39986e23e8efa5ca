# SPDX-License-Identifier: GPL-3.0-or-later
# The fuzz target, linked with libFuzzer. What it finds in a minute fails the test; the input is then in
# the build folder, and goes to regressions/ once the defect is mended.
add_executable(vbm_fuzz_build fuzz_build.cpp)
target_link_libraries(vbm_fuzz_build PRIVATE vbm_test_checks vbm_warnings)
target_link_options(vbm_fuzz_build PRIVATE -fsanitize=fuzzer)
set(seeds ${CMAKE_CURRENT_SOURCE_DIR}/regressions)
if(NOT EXISTS ${seeds}) # until something is found
  set(seeds)
endif()
file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/corpus)
add_test(NAME robustness.fuzz_minute
  COMMAND vbm_fuzz_build -max_total_time=60 -timeout=20 -rss_limit_mb=4000 -max_len=800 -seed=1
    -print_final_stats=1 corpus ${seeds}
  WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
set_tests_properties(robustness.fuzz_minute PROPERTIES TIMEOUT 300)
