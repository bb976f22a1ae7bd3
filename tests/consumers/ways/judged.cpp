#include <lobe/testkit.hpp>

/// Lambert, in a project's own words.
struct matte {
    using scalar = float;
    float f_cos(glm::vec3 v, glm::vec3 l) const { return v.z > 0 && l.z > 0 ? 0.25f * l.z : 0; }
};

int main() { return lobe::testkit::verify(matte{}) ? 0 : 1; }
