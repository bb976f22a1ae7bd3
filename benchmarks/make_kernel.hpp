// The two ways to run a variant, a function `at` of the inputs and an index, over the arrays. Each translation unit
// that includes this is compiled for its own instruction set; hence the unnamed namespace. `at` is inlined by force, as
// if its line stood in the loop: as a function with two callers it would be called, and a loop with a call does not
// vectorise.
#pragma once

#include "rows.hpp"

#include <bit>
#include <utility>

template <std::size_t N, class T = float>
struct result {
    static constexpr std::size_t size = N;
    T value[N];
};

namespace {

template <class Variant>
constexpr std::size_t components = decltype(Variant::at(std::declval<const inputs&>(), 0))::size;

/// One at a time: each call waits for the result of the one before, because its index depends on it.
template <class Variant>
[[gnu::noinline]] std::uint32_t call(const inputs& in, std::size_t i) {
    const auto r = Variant::at(in, i);
    std::uint32_t bits = 0;
    for (const float x : r.value) bits |= std::bit_cast<std::uint32_t>(x);
    return bits;
}
template <class Variant>
std::uint32_t one_at_a_time(const inputs& in, std::uint32_t zero) {
    std::uint32_t last = 0;
    for (std::size_t i = 0; i < count; ++i) last = call<Variant>(in, i + (last & zero));
    return last;
}

/// A plain loop over arrays, for the compiler to vectorise.
template <class Variant>
[[gnu::noinline]] void plain_loop(const inputs& in, float* __restrict out) {
    for (std::size_t i = 0; i < count; ++i) {
        const auto r = Variant::at(in, i);
        [&]<std::size_t... K>(std::index_sequence<K...>) { ((out[K * stride + i] = r.value[K]), ...); }
        (std::make_index_sequence<components<Variant>>{});
    }
}

template <class Variant>
kernel kernel_of() {
    return {components<Variant>, one_at_a_time<Variant>, plain_loop<Variant>};
}

}  // namespace
