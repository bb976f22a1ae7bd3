#pragma once

#include "progress.hpp"

#include <cstddef>
#include <string>

#include <tbb/parallel_for.h>

/// Shares rows out among the cores, and shows them as a step: what the library's `make_cube`, `prefilter`, ... ask for.
/// `before_each` may stop it with an exception.
inline auto rows_of(
    const std::string& name, void (*before_each)() = [] {}) {
    return [name, before_each](int rows, const auto& g) {
        step progress(name, static_cast<std::size_t>(rows));
        tbb::parallel_for(0, rows, [&](int row) {
            before_each();
            g(row);
            progress.advance();
        });
    };
}
