// What a property of a BRDF is: something that looks at pairs of directions, at samples and at views, and reports.
#pragma once

#include <lobe/testkit/subject/subject.hpp>
#include <lobe/testkit/verdict/report.hpp>
#include <lobe/testkit/verdict/view.hpp>

#include <array>

namespace lobe::testkit::detail {

/// Two directions above the horizon, and f_cos there.
template <class T, std::size_t N>
struct pair_of_directions {
    vec3<T> v{}, l{};
    std::array<double, N> f{};
};

/// A sample that succeeded, what it was drawn from, and f_cos there.
template <class T, std::size_t N>
struct sample_from {
    vec3<T> v{}, u{};
    drawn<T, N> s{};
    std::array<double, N> f{};
    place<T> at{};
};

/// A property overrides what it wants to see; what it needs beyond that it asks of the subject itself.
template <class T, std::size_t N>
class brdf_property {
public:
    using V = vec3<T>;
    using values = std::array<double, N>;
    using pair = pair_of_directions<T, N>;
    using sample = sample_from<T, N>;
    using view = detail::view<T, N>;

    explicit brdf_property(subject<T, N>& judged) : b(judged) {}
    virtual ~brdf_property() = default;
    brdf_property(const brdf_property&) = delete;
    brdf_property& operator=(const brdf_property&) = delete;

    virtual void at_pair(const pair&) {}      // a few thousand, spread over all scales
    virtual void at_sample(const sample&) {}  // drawn from the v of pairs and from views
    virtual void at_view(const view&) {}      // a dozen, each with its integrals
    virtual void report_to(report&) = 0;

protected:
    subject<T, N>& b;
};

}  // namespace lobe::testkit::detail
