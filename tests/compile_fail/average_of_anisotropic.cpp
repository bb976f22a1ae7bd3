// An albedo by cosine alone has no meaning for an anisotropic BRDF.
#include <lobe/lobe.hpp>

double albedo() {
#ifdef LOBE_SHOULD_COMPILE
    const lobe::microfacet brdf{lobe::ggx{lobe::alpha{0.1}}, lobe::smith_correlated{}, lobe::perfect_reflector{}};
#else
    const lobe::microfacet brdf{lobe::ggx{lobe::alpha_xy{0.1, 0.2}}, lobe::smith_correlated{},
                                lobe::perfect_reflector{}};
#endif
    return lobe::average_albedo(brdf);
}
