// The split-sum terms of GGX from a table that comes with the library.
#pragma once

#include <lobe/energy/default_dfg_data.hpp>
#include <lobe/energy/dfg_table.hpp>

namespace lobe {

/// The `dfg_table` of 32 x 32 of isotropic GGX with `smith_correlated`, ready-made: 8.7 kB of constants, no state.
/// Domain and error: as `dfg_table`. Scalar types only; on the host (-> `dfg_fit_precise`).
struct default_dfg {
    template <class N, class Masking>
    static constexpr bool describes = detail::is_smith_ggx<N, Masking>;

    template <scalar T>
    [[gnu::always_inline]] dfg_terms<T> operator()(const T& cosine, const alpha<T>& a) const {
        return parts().terms(cosine, a);
    }
    template <scalar T>
    dfg_terms<T> average(const alpha<T>& a) const {
        return parts().average(a);
    }

    /// What it consists of, for other languages: lobe/shader/dfg.hpp.
    static detail::dfg_grids<float> parts() {
        return {{detail::default_dfg_missing, 32}, {detail::default_dfg_averages, 64}};
    }
};

}  // namespace lobe
