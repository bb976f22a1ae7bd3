// Distributions on SIMD packs: what is not for scalar types only gives in each lane what it gives for one number.
#include "catch.hpp"
#include "ndf_support.hpp"

#include <xsimd/xsimd.hpp>

using lobe::vec2;
using lobe::vec3;

namespace {

template <class Pack>
void compare_packs(double tolerance) {
    using T = typename Pack::value_type;
    random_numbers random(1);
    const auto worst_of = [](const Pack& wide, const auto& one, double floor = 1e-30) {
        double worst = 0;
        for (std::size_t i = 0; i < Pack::size; ++i) {
            const double exact = static_cast<double>(one(i));
            worst =
                larger(worst, std::abs(static_cast<double>(wide.get(i)) - exact) / std::max(std::abs(exact), floor));
        }
        return worst;
    };
    double D = 0, power = 0, area = 0, samples = 0;
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<vec3<T>> lanes;
        std::vector<vec2<T>> us;
        std::vector<T> x, y, z, ux, uy;
        for (std::size_t i = 0; i < Pack::size; ++i) {
            const vec3<T> m = random.grazing_direction<T>(0.05);
            const vec2<T> u{static_cast<T>(random() * 0.999), static_cast<T>(random() * 0.999)};
            lanes.push_back(m), us.push_back(u);
            x.push_back(m.x), y.push_back(m.y), z.push_back(m.z), ux.push_back(u.x), uy.push_back(u.y);
        }
        const vec3<Pack> m{Pack::load_unaligned(x.data()), Pack::load_unaligned(y.data()),
                           Pack::load_unaligned(z.data())};
        const vec2<Pack> u{Pack::load_unaligned(ux.data()), Pack::load_unaligned(uy.data())};
        const lobe::alpha<T> a(T(0.4));
        const lobe::alpha<Pack> aw(Pack(T(0.4)));
        const lobe::alpha_xy<T> axy(T(0.4), T(0.7));
        const lobe::alpha_xy<Pack> axyw(Pack(T(0.4)), Pack(T(0.7)));
        const auto compare = [&](const auto& wide, const auto& one) {
            D = larger(D, worst_of(wide.D(m), [&](std::size_t i) { return one.D(lanes[i]); }));
        };
        const auto compare_area = [&](const auto& wide, const auto& one) {
            area = larger(area,
                          worst_of(
                              wide.projected_area(m), [&](std::size_t i) { return one.projected_area(lanes[i]); }, 1));
            area = larger(
                area, worst_of(
                          wide.projected_area(-m), [&](std::size_t i) { return one.projected_area(-lanes[i]); }, 1));
        };
        const auto compare_samples = [&](const auto& wide, const auto& one) {
            samples = larger(samples, worst_of(wide.sample(u).z, [&](std::size_t i) { return one.sample(us[i]).z; }));
        };
        compare(lobe::beckmann{axyw}, lobe::beckmann{axy});
        compare_area(lobe::beckmann{axyw}, lobe::beckmann{axy});
        compare_samples(lobe::beckmann{axyw}, lobe::beckmann{axy});
        compare_area(lobe::beckmann_walter{aw}, lobe::beckmann_walter{a});
        compare(lobe::student_t{axyw, Pack(T(2.5))}, lobe::student_t{axy, T(2.5)});
        compare_samples(lobe::student_t{axyw, Pack(T(2.5))}, lobe::student_t{axy, T(2.5)});
        compare(lobe::blinn_phong{aw}, lobe::blinn_phong{a});
        compare_samples(lobe::blinn_phong{aw}, lobe::blinn_phong{a});
        const lobe::mixture both{lobe::ggx{a}, lobe::beckmann{a}, T(0.4)};
        const lobe::mixture both_wide{lobe::ggx{aw}, lobe::beckmann{aw}, Pack(T(0.4))};
        compare(both_wide, both);
        compare_area(both_wide, both);
        compare_samples(both_wide, both);
        compare_area(lobe::masked_by{lobe::blinn_phong{aw}, lobe::ggx{aw}},
                     lobe::masked_by{lobe::blinn_phong{a}, lobe::ggx{a}});
        compare(lobe::gtr{aw, Pack(T(1))}, lobe::gtr{a, T(1)});
        compare_samples(lobe::gtr{aw, Pack(T(1))}, lobe::gtr{a, T(1)});
        compare(lobe::phong{aw}, lobe::phong{a});
        compare_samples(lobe::phong{aw}, lobe::phong{a});
        compare(lobe::abc{aw, Pack(T(1.5))}, lobe::abc{a, T(1.5)});
        const lobe::exponential_power power_wide{axyw, Pack(T(1.5))};
        const lobe::exponential_power one_power{axy, T(1.5)};
        power = larger(power, worst_of(power_wide.D(m), [&](std::size_t i) { return one_power.D(lanes[i]); }));
        compare_area(lobe::masked_by{lobe::gtr{aw, Pack(T(1))}, lobe::ggx{aw}},
                     lobe::masked_by{lobe::gtr{a, T(1)}, lobe::ggx{a}});
        compare(lobe::sggx{axyw}, lobe::sggx{axy});
        samples = larger(samples, worst_of(lobe::sggx{axyw}.sample_visible(m, u).z, [&](std::size_t i) {
                                      return lobe::sggx{axy}.sample_visible(lanes[i], us[i]).z;
                                  }) / 1000);
    }
    INFO("relative: D " << D << ", with a power in the exponent " << power << ", areas " << area << ", samples "
                        << samples);
    CHECK(D < tolerance);
    CHECK(power < 5 * tolerance);  // a power of packs is exp(p ln tau), whose error is that of ln D times 1 + ln(60)
    CHECK(area < tolerance);
    CHECK(samples < tolerance);
}

}  // namespace

TEST_CASE("a pack of distributions gives what its lanes give", "[ndf]") {
    // the exponentials and logarithms of packs differ from libm's by an ULP or two, which |ln D| multiplies, here up to
    // 60
    compare_packs<xsimd::batch<float>>(200 * 6e-8);
    compare_packs<xsimd::batch<double>>(200 * 1.1e-16);
}
