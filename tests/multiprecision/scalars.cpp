// The library on 50 digits: the properties of tests/scalars.cpp.
#include "../catch.hpp"
#include "../scalars/properties.hpp"
#include "digits50.hpp"

TEST_CASE("one text of the formulas holds on 50 digits", "[multiprecision][scalars]") {
    scalars::verify_all<digits50>();
}
