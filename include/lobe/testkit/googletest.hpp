// Glue for GoogleTest: EXPECT_TRUE(passed(verify(brdf))) prints the report where it fails. (Catch2 needs none:
// REQUIRE(verify(brdf)).)
#pragma once

#include <lobe/testkit/verdict/report.hpp>

#include <gtest/gtest.h>

namespace lobe::testkit {

inline ::testing::AssertionResult passed(const report& r) {
    return (r.passed() ? ::testing::AssertionSuccess() : ::testing::AssertionFailure()) << r;
}

}  // namespace lobe::testkit
