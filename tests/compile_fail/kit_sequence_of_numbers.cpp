// error: no range of points with x and y
// of: verify_sequence
#include <lobe/testkit.hpp>

#include <vector>

#ifdef LOBE_SHOULD_COMPILE
bool verdict(const std::vector<glm::vec2>& points) { return lobe::testkit::verify_sequence(points).passed(); }
#else
bool verdict(const std::vector<float>& points) { return lobe::testkit::verify_sequence(points).passed(); }
#endif
