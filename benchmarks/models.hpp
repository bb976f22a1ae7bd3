// Every model of the library as rows of the report: a model is a function of an element, an operation is what is asked
// of it, and both are generic in the scalar type, so that the same line is the kernel in float and its exact result in
// long double.
#pragma once

#include "element.hpp"
#include "make_kernel.hpp"
#include "rows.hpp"

namespace {

#ifdef BENCH_KERNELS_ONLY
constexpr bool exact_results_too = false;  // the other build has them
#else
constexpr bool exact_results_too = true;
#endif

constexpr real not_counted = std::numeric_limits<real>::quiet_NaN();

template <class T>
result<1, T> one(const T& x) {
    return {x};
}
template <class T>
result<2, T> two(const lobe::vec2<T>& w) {
    return {w.x, w.y};
}
template <class T>
result<2, T> two(const lobe::dfg_terms<T>& t) {
    return {t.scale, t.bias};
}
template <class T>
result<3, T> three(const lobe::vec3<T>& w) {
    return {w.x, w.y, w.z};
}
template <class T>
result<4, T> four(const lobe::vec3<T>& w, const T& x) {
    return {w.x, w.y, w.z, x};
}

/// The operation of a model that is the result itself.
struct itself {
    [[gnu::always_inline]] static auto of(const auto& model, const auto&) { return model; }
};

struct f_cos {
    [[gnu::always_inline]] static auto of(const auto& brdf, const auto& e) { return three(brdf.f_cos(e.v(), e.l())); }
};
struct evaluate {
    [[gnu::always_inline]] static auto of(const auto& brdf, const auto& e) {
        const auto both = brdf.evaluate(e.v(), e.l());
        return four(both.f_cos, both.pdf);
    }
};

/// Where a sampled direction grazes the horizon rounding decides whether the sample fails: those are not counted.
struct sample {
    [[gnu::always_inline]] static auto of(const auto& brdf, const auto& e) {
        auto s = brdf.sample(e.v(), e.u());
        using T = decltype(s.pdf);
        if constexpr (std::same_as<T, real>)
            if (s.l.z < 1e-4L) s.pdf = not_counted;
        return result<7, T>{s.l.x, s.l.y, s.l.z, s.weight.x, s.weight.y, s.weight.z, s.pdf};
    }
};

const std::vector<metric> sample_metrics{{"l", unit_of_error::direction, 0, 3},
                                         {"weight", unit_of_error::weight, 3, 3},
                                         {"pdf", unit_of_error::relative, 6, 1}};

template <class Operation, class Model>
struct model_variant {
    [[gnu::always_inline]] static auto at(const inputs& in, std::size_t i) {
        const element<float> e{in, i};
        return Operation::of(Model{}(e), e);
    }
};

template <class Operation, class Model>
void exactly(const inputs& in, std::size_t i, real* out) {
    const element<real> e{in, i};
    for (const real x : Operation::of(Model{}(e), e).value) *out++ = x;
}
template <class Operation, class Model>
constexpr exact_result exact_of() {
    if constexpr (exact_results_too)
        return exactly<Operation, Model>;
    else
        return nullptr;
}

/// The rows of one operation. Models are lambdas that capture nothing, so that their types are all there is to know.
template <class Operation>
class rows_of {
public:
    rows_of(const char* title, std::vector<metric> metrics) : made{title, std::move(metrics), {}} {}

    /// A model whose only error is that of its arithmetic, or of its table.
    template <class Model>
    void add(const std::string& label, Model, const char* kind = "rounding") {
        push(label, kernel_of<model_variant<Operation, Model>>(), {{kind, exact_of<Operation, Model>()}});
    }
    /// ... and how far it is from another model, which it approximates.
    template <class Model, class Exact>
    void add(const std::string& label, Model model, const char* exact_model, Exact) {
        add(label, model);
        made.rows.back().references.push_back({std::string("from ") + exact_model, exact_of<Operation, Exact>()});
    }
    /// A model in float alone, whose result is compared with `Exact`, a result of its own.
    template <class Model, class Exact>
    void against(const std::string& label, Model, Exact, const char* kind = "rounding") {
        push(label, kernel_of<model_variant<Operation, Model>>(), {{kind, exact_of<itself, Exact>()}});
    }
    /// One call that is a whole pass over the elements, only timed.
    template <class Call>
    void pass(const std::string& label, Call) {
        const auto once = [](const inputs&, std::uint32_t) { return std::bit_cast<std::uint32_t>(Call{}()); };
        push(label, {0, once, nullptr, false}, {});
    }

    /// Of the last row: nothing to compare, or nothing that a loop would add.
    void only_timed() { made.rows.back().references.clear(); }
    void not_in_a_loop() { made.rows.back().code.loop_is_timed = false; }

    section made;

private:
    void push(const std::string& label, const kernel& code, std::vector<reference> references) {
        made.rows.push_back({made.title + ": " + label, label, code, std::move(references)});
    }
};

}  // namespace
