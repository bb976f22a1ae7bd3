// Nor the points that a light is asked for.
#include <lobe/lobe.hpp>

float illuminance(const glm::dvec3& point) {
    const lobe::point_light light{glm::vec3(0, 0, 1), 1.0f};
#ifdef LOBE_SHOULD_COMPILE
    return light(glm::vec3(point)).illuminance;
#else
    return light(point).illuminance;
#endif
}
