// error: no f_cos(v, l), nor a call (v, l)
// of: verify
#include <lobe/testkit.hpp>

struct subject {
#ifdef LOBE_SHOULD_COMPILE
    float f_cos(const glm::vec3&, const glm::vec3& l) const { return l.z > 0 ? 0.2f * l.z : 0.0f; }
#else
    float value(float x) const { return x; }
#endif
};

bool verdict() { return lobe::testkit::verify(subject{}).passed(); }
