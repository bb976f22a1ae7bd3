// error: this family of distributions is not shape-invariant: it has one width, alpha, and no alpha_xy
// of: phong{alpha_xy{0.3f, 0.2f}}; blinn_phong{alpha_xy{0.3f, 0.2f}}; gtr{alpha_xy{0.3f, 0.2f}, 1.0f}
// of: abc{alpha_xy{0.3f, 0.2f}, 1.5f}; sgd{alpha_xy{0.3f, 0.2f}, 1.0f}
#include <lobe/lobe.hpp>

using namespace lobe;

auto peak() {
#ifdef LOBE_SHOULD_COMPILE
    const auto ndf = beckmann{alpha_xy{0.3f, 0.2f}};
#else
    const auto ndf = phong{alpha_xy{0.3f, 0.2f}};
#endif
    return ndf.D({0, 0, 1});
}
