#include <lobe/lobe.hpp>

/// f_cos of a rough gold, from another unit.
float other_unit(const glm::vec3& v, const glm::vec3& l);
