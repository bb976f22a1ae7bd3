// error: the numbers of a distribution are of one type: gtr{alpha{0.3f}, 1.5f}, not 1.5
// of: gtr{alpha{0.3f}, 1.5}; gtr{alpha{0.3}, 1.5f}; abc{alpha{0.3f}, 1.5}; sgd{alpha{0.3f}, 1.0}
// of: student_t{alpha{0.3f}, 2.0}; student_t{alpha_xy{0.3f, 0.2f}, 2.0}; hyper_cauchy{alpha{0.3f}, 2.0}
// of: exponential_power{alpha_xy{0.3, 0.2}, 2.0f}
#include <lobe/lobe.hpp>

using namespace lobe;

auto peak() {
#ifdef LOBE_SHOULD_COMPILE
    const auto ndf = gtr{alpha{0.3f}, 1.5f};
#else
    const auto ndf = gtr{alpha{0.3f}, 1.5};
#endif
    return ndf.D({0, 0, 1});
}
