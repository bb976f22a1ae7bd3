// error: no D(m), nor a call (m)
// of: verify_distribution
#include <lobe/testkit.hpp>

struct subject {
#ifdef LOBE_SHOULD_COMPILE
    float D(const glm::vec3& m) const { return m.z > 0 ? 0.3183f : 0.0f; }
#else
    float value(float x) const { return x; }
#endif
};

bool verdict() { return lobe::testkit::verify_distribution(subject{}).passed(); }
