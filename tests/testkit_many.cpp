// Functions that take arrays are judged as those of one direction are, in a hundredth of the calls.
#include "catch.hpp"

#include <lobe/testkit/subject/adapters.hpp>
#include <lobe/testkit/subject/many_at_once.hpp>
#include <lobe/testkit/verify.hpp>

#include <stdexcept>

using namespace lobe::testkit;
using V = glm::dvec3;

namespace {

constexpr std::size_t channels = 1;

struct counted {
    long calls = 0, places = 0;
};

V at(const std::vector<double>& w, std::size_t i) { return {w[3 * i], w[3 * i + 1], w[3 * i + 2]}; }

template <class B>
detail::array_functions arrays_of(const B& b, counted& n) {
    const auto each = [&n](const detail::questions& q, const auto& f) {
        ++n.calls, n.places += static_cast<long>(q.count());
        for (std::size_t i = 0; i < q.count(); ++i) f(i, at(q.v, i), at(q.w, i));
    };
    detail::array_functions out;
    out.f_cos = [=](const detail::questions& q, detail::answers& a) {
        each(q, [&](std::size_t i, V v, V l) { a.values[i] = b.f_cos(v, l); });
    };
    out.pdf = [=](const detail::questions& q, detail::answers& a) {
        each(q, [&](std::size_t i, V v, V l) { a.pdf[i] = b.pdf(v, l); });
    };
    out.sample = [=](const detail::questions& q, detail::answers& a) {
        each(q, [&](std::size_t i, V v, V u) {
            const auto s = b.sample(v, glm::dvec2(u));
            a.values[i] = s.weight, a.pdf[i] = s.pdf;
            for (int k = 0; k < 3; ++k) a.l[3 * i + static_cast<std::size_t>(k)] = s.l[k];
        });
    };
    return out;
}

template <class B>
report many(const B& b, counted& n, const options& o = {}) {
    detail::many_at_once<double, channels> all(arrays_of(b, n));
    return detail::verdict_on(all.one_at_a_time(), o);
}

/// Cosine-weighted, of a density and weight that are wrong by a factor.
struct matt {
    double factor = 1, least = 0;
    double f_cos(V v, V l) const { return v.z > 0 && l.z > 0 ? 0.25 * l.z : 0; }
    double pdf(V, V l) const { return l.z > least ? factor * l.z / lobe::testkit::detail::tau * 2 : 0; }
    sampled_light<double, double> sample(V v, glm::dvec2 u) const {
        const double r = std::sqrt(u.x), turn = detail::tau * u.y;
        const V l(r * std::cos(turn), r * std::sin(turn), std::sqrt(1 - u.x));
        const double p = pdf(v, l);
        return {l, p > 0 ? f_cos(v, l) / p : 0, p};
    }
};

}  // namespace

TEST_CASE("Arrays: the same verdict as of one direction at a time in fewer calls", "[testkit]") {
    for (const matt& b : {matt{}, matt{.factor = 1.02}, matt{.least = 0.3}}) {
        counted n;
        CHECK(many(b, n).text() == verify(b).text());
        CHECK(n.places > 300000);
        CHECK(n.calls < n.places / 100);
        INFO(n.calls << " calls for " << n.places);
    }
}

TEST_CASE("Arrays: nobody listens afterwards and what is asked twice is answered twice", "[testkit]") {
    counted n;
    const matt b;
    {
        detail::many_at_once<double, channels> all(arrays_of(b, n));
        const auto one = all.one_at_a_time();
        const V up(0, 0, 1);
        detail::rehearse([&] { one.f_cos(up, up), one.f_cos(up, up), one.f_cos(up, -up); });
        CHECK(n.calls == 1);
        CHECK(n.places == 3);
        for (int i = 0; i < 3; ++i) CHECK(one.f_cos(up, up)[0] == 0.25);  // known, known, asked for
        CHECK(n.calls == 2);
        CHECK_THROWS_AS(detail::rehearse([] { throw std::runtime_error("mine"); }), std::runtime_error);
        CHECK(!detail::rehearsing());
    }
    CHECK(detail::listener::current == nullptr);
}

TEST_CASE("Arrays: a function that throws is a finding", "[testkit]") {
    counted n;
    detail::array_functions f = arrays_of(matt{}, n);
    f.pdf = [](const detail::questions&, detail::answers&) { throw std::runtime_error("out of memory"); };
    detail::many_at_once<double, channels> all(f);
    const report r = detail::verdict_on(all.one_at_a_time(), options{});
    CHECK_FALSE(r.passed());
    CHECK(r.text().find("it threw: out of memory") != std::string::npos);
}
