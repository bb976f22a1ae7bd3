// GLM would convert the view of a double renderer to float without a word.
#include <lobe/lobe.hpp>

float shade(const glm::dvec3& v) {
    const auto light = lobe::directional_light{glm::vec3(0, 0, 1), 1.0f}(glm::vec3(0));
#ifdef LOBE_SHOULD_COMPILE
    return lobe::reflected_radiance(lobe::lambert{0.5f}, glm::vec3(v), light);
#else
    return lobe::reflected_radiance(lobe::lambert{0.5f}, v, light);
#endif
}
