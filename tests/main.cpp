// Catch2 v2 has no library with a main: this is it. Catch2 v3 builds do not compile this file.
#define CATCH_CONFIG_MAIN
#include "catch.hpp"
