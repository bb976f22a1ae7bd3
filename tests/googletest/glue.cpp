#include <lobe/testkit.hpp>
#include <lobe/testkit/googletest.hpp>

#include <gtest/gtest-spi.h>

namespace {

auto lambert(float factor) {
    return [factor](glm::vec3 v, glm::vec3 l) { return v.z > 0 && l.z > 0 ? factor * l.z / 3.14159265f : 0.f; };
}

TEST(Testkit, ARightBrdfPasses) { EXPECT_TRUE(lobe::testkit::passed(lobe::testkit::verify(lambert(0.5f)))); }

TEST(Testkit, AFailurePrintsTheReport) {
    EXPECT_NONFATAL_FAILURE(EXPECT_TRUE(lobe::testkit::passed(lobe::testkit::verify(lambert(3.14159265f)))),
                            "missing 1/pi");
}

}  // namespace
