// error: a bare number is no width: write alpha{0.3f}, or alpha<float>::from_roughness(r)
// of: table(mu, roughness)
#include <lobe/lobe.hpp>

// The split-sum table takes an alpha, not a number that might be a roughness.
float scale(float mu, float roughness) {
    const auto table = lobe::bake_dfg<float>(lobe::smith_correlated{});
#ifdef LOBE_SHOULD_COMPILE
    return table(mu, lobe::alpha<float>::from_roughness(roughness, 1e-4f)).scale;
#else
    return table(mu, roughness).scale;
#endif
}
