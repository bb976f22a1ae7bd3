#include <lobe/core/vector.hpp>

#if defined(EXPECT_THE_GLM_OF_THE_PROJECT) && !defined(GLM_OF_THE_PROJECT)
#error this is another GLM
#endif

int main() { return lobe::dot(lobe::vec3<float>(1, 2, 3), lobe::vec3<float>(3, 0, -1)) > 0; }
