// A stranger's functions that take arrays, as the functions of one direction that the judge asks.
#pragma once

#include <lobe/testkit/measure/rehearse.hpp>
#include <lobe/testkit/subject/brdf.hpp>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace lobe::testkit::detail {

/// Questions of one kind: `v`, and `w`, which is l or u; three numbers each, one place after another.
struct questions {
    std::vector<double> v, w;
    std::size_t count() const { return v.size() / 3; }
};
/// The answers: f_cos or weight, `N` numbers a place; pdf; three numbers of l.
struct answers {
    std::vector<double> values, pdf, l;
};

/// One call for many places; it fills what it is about, which is of the right size.
struct array_functions {
    std::function<void(const questions&, answers&)> f_cos, pdf, sample;  // the last two may be empty
};

/// Each answer serves once, so that who asks twice asks the stranger twice.
template <class T, std::size_t N>
class many_at_once : public listener {
public:
    explicit many_at_once(array_functions of) : functions(std::move(of)), outer(std::exchange(current, this)) {}
    ~many_at_once() override { current = outer; }

    /// To be judged while this lives.
    brdf_functions<T, N> one_at_a_time() {
        using V = vec3<T>;
        brdf_functions<T, N> out;
        out.f_cos = [this](const V& v, const V& l) { return answer(f, v, l).values; };
        if (functions.pdf) out.pdf = [this](const V& v, const V& l) { return answer(density, v, l).pdf; };
        if (functions.sample)
            out.sample = [this](const V& v, const V& u) {
                const known& a = answer(drawing, v, u);
                return drawn<T, N>{.l = V(a.l), .weight = a.values, .pdf = a.pdf};
            };
        return out;
    }

    bool ask() override {
        bool any = false;
        for (const kind k : {f, density, drawing}) {
            if (noted[k].count() == 0) continue;
            any = true;
            const questions all = std::exchange(noted[k], {});
            call(k, all);
            for (std::size_t i = 0; i < all.count(); ++i) {
                const double *v = &all.v[3 * i], *w = &all.w[3 * i];
                memory.emplace(key{k, {v[0], v[1], v[2]}, {w[0], w[1], w[2]}}, read(k, i));
            }
        }
        return any;
    }

private:
    enum kind { f, density, drawing };
    struct known {
        std::array<double, N> values{};
        double pdf = 0;
        vec3<double> l{};
    };
    struct key {
        kind of;
        std::array<double, 3> v, w;
        /// By their bits: 0 and -0 are two, and NaN is itself.
        bool operator==(const key& b) const { return of == b.of && bits() == b.bits(); }
        std::array<std::uint64_t, 6> bits() const {
            std::array<std::uint64_t, 6> out;
            for (std::size_t i = 0; i < 3; ++i)
                out[i] = std::bit_cast<std::uint64_t>(v[i]), out[i + 3] = std::bit_cast<std::uint64_t>(w[i]);
            return out;
        }
    };
    struct hash {
        std::size_t operator()(const key& k) const {
            std::uint64_t h = static_cast<std::uint64_t>(k.of);
            for (const std::uint64_t x : k.bits()) h = (h ^ x ^ (h >> 29)) * 0x9e3779b97f4a7c15u;
            return static_cast<std::size_t>(h ^ (h >> 32));
        }
    };

    void call(kind k, const questions& all) {
        const std::size_t n = all.count();
        got.values.assign(k == density ? 0 : n * N, 0);
        got.pdf.assign(k == f ? 0 : n, 0);
        got.l.assign(k == drawing ? 3 * n : 0, 0);
        (k == f ? functions.f_cos : k == density ? functions.pdf : functions.sample)(all, got);
    }
    known read(kind k, std::size_t i) const {
        known a;
        if (k != density)
            for (std::size_t c = 0; c < N; ++c) a.values[c] = got.values[i * N + c];
        if (k != f) a.pdf = got.pdf[i];
        if (k == drawing) a.l = {got.l[3 * i], got.l[3 * i + 1], got.l[3 * i + 2]};
        return a;
    }

    const known& answer(kind k, const vec3<T>& v, const vec3<T>& w) {
        const auto exact = [](const vec3<T>& x) {
            return std::array<double, 3>{static_cast<double>(x.x), static_cast<double>(x.y), static_cast<double>(x.z)};
        };
        const key here{k, exact(v), exact(w)};
        const auto found = memory.find(here);
        if (listens) {
            if (found != memory.end()) return latest = found->second;
            noted[k].v.insert(noted[k].v.end(), here.v.begin(), here.v.end());
            noted[k].w.insert(noted[k].w.end(), here.w.begin(), here.w.end());
            return latest = {};
        }
        if (found != memory.end()) {
            latest = found->second;
            memory.erase(found);
            return latest;
        }
        if (memory.size() > most_kept) memory.clear();  // rehearsed and never asked for
        call(k, {{here.v.begin(), here.v.end()}, {here.w.begin(), here.w.end()}});
        return latest = read(k, 0);
    }

    static constexpr std::size_t most_kept = std::size_t(1) << 18;
    array_functions functions;
    listener* outer;
    std::array<questions, 3> noted{};
    std::unordered_multimap<key, known, hash> memory;
    answers got;
    known latest;
};

}  // namespace lobe::testkit::detail
