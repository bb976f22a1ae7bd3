#include <lobe/lobe.hpp>

#include <cmath>

int main() {
    const lobe::microfacet brdf{lobe::ggx{lobe::alpha{0.3f}}, lobe::smith_correlated{}, lobe::schlick{0.04f}};
    const glm::vec3 v{0.6f, 0.0f, 0.8f}, l{0.0f, 0.6f, 0.8f};
    const float value = brdf.f_cos(v, l);
    return std::isfinite(value) && value > 0 ? 0 : 1;
}
