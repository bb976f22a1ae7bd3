// error: F(cosine) returns no spectrum
// of: verify_fresnel
#include <lobe/testkit.hpp>

struct subject {
#ifdef LOBE_SHOULD_COMPILE
    float operator()(float) const { return 0.5f; }
#else
    float value(float x) const { return x; }
#endif
};

bool verdict() { return lobe::testkit::verify_fresnel(subject{}).passed(); }
