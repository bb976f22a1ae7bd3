// Every model of the library as rows of the report: a model is a function of an element, an operation is what is asked of it, and
// both are generic in the scalar type, so that the same line is the kernel in float and its exact result in long double.
#pragma once

#include "element.hpp"
#include "make_kernel.hpp"
#include "rows.hpp"

/// A section, and the kernels of its rows.
struct model_section {
    section rows;
    std::vector<kernel> kernels;
};

std::vector<model_section> distribution_models();
std::vector<model_section> brdf_part_models();
std::vector<model_section> sampler_models();
std::vector<model_section> other_models();

inline std::vector<model_section> all_models() {
    std::vector<model_section> all;
    for (const auto& models : {distribution_models(), brdf_part_models(), sampler_models(), other_models()})
        all.insert(all.end(), models.begin(), models.end());
    return all;
}

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
    rows_of(const char* title, const char* note, std::vector<metric> metrics) : made{{title, note, std::move(metrics), {}, {}}, {}} {}

    /// A model whose only error is that of its arithmetic, or of its table.
    template <class Model>
    void add(const std::string& label, Model, const char* kind = "rounding") {
        const std::string name = made.rows.title + ": " + label;
        made.kernels.push_back(kernel_of<model_variant<Operation, Model>>(name));
        made.rows.rows.push_back({name, label, {{kind, exact_of<Operation, Model>()}}});
    }
    /// ... and how far it is from another model, which it approximates.
    template <class Model, class Exact>
    void add(const std::string& label, Model model, const char* exact_model, Exact) {
        add(label, model);
        made.rows.rows.back().references.push_back({std::string("from ") + exact_model, exact_of<Operation, Exact>()});
    }

    /// Of the last row: nothing to compare, or nothing that a loop would add.
    void only_timed() {
        made.kernels.back().components = 0;
        made.rows.rows.back().references.clear();
    }
    void not_in_a_loop() { made.kernels.back().loop_is_timed = false; }

    model_section made;
};

}  // namespace
