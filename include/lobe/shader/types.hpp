// What a recorded function takes and returns: numbers, vectors, masks, and structs of them.
#pragma once

#include <lobe/core/vector.hpp>
#include <lobe/shader/real.hpp>

#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace lobe::shader {

struct structure;

struct type {
    enum kinds { number, vector_2, vector_3, truth, record } kind = number;
    std::shared_ptr<const structure> of;  // a record
};

struct structure {
    struct member {
        std::string name;
        shader::type type;
    };
    std::string name;
    std::vector<member> members;
};

/// How many numbers or truths a type consists of.
inline std::uint32_t components(const type& t) {
    switch (t.kind) {
        case type::vector_2: return 2;
        case type::vector_3: return 3;
        case type::record: {
            std::uint32_t total = 0;
            for (const auto& m : t.of->members) total += components(m.type);
            return total;
        }
        default: return 1;
    }
}

/// A member of a struct and its name.
template <class S, class M>
struct field {
    const char* name;
    M S::*member;
};
template <class S, class M>
field(const char*, M S::*) -> field<S, M>;

/// The members of a struct that functions may take and return; to be specialised for one of your own:
///   template <> struct lobe::shader::members<material> {
///       static constexpr auto name = "material";
///       static constexpr std::tuple fields{field{"base_color", &material::base_color}, ...};
///   };
template <class S>
struct members;

namespace detail {

template <class S>
concept described = requires {
    members<S>::name;
    members<S>::fields;
};

/// Type, components in order, and the value that a sequence of components makes, of each type.
template <class V>
struct layout {
    static_assert(described<V>, "a recorded function takes and returns real, vec2, vec3, mask, and structs of which "
                                "lobe::shader::members names the fields: specialise it for yours");
    static type describe() {
        structure s{members<V>::name, {}};
        each([&](const auto& f) { s.members.push_back({f.name, layout<field_t<decltype(f)>>::describe()}); });
        return {type::record, std::make_shared<structure>(s)};
    }
    static void flatten(const V& value, tape& owner, std::vector<const node*>& to) {
        each([&](const auto& f) { layout<field_t<decltype(f)>>::flatten(value.*f.member, owner, to); });
    }
    template <class Next>
    static V build(const Next& next) {
        V value{};
        each([&](const auto& f) { value.*f.member = layout<field_t<decltype(f)>>::build(next); });
        return value;
    }

private:
    template <class F>
    using field_t = std::remove_cvref_t<decltype(std::declval<V&>().*std::declval<F>().member)>;
    template <class G>
    static void each(const G& g) {
        std::apply([&](const auto&... f) { (g(f), ...); }, members<V>::fields);
    }
};

template <>
struct layout<real> {
    static type describe() { return {type::number, nullptr}; }
    static void flatten(const real& x, tape& owner, std::vector<const node*>& to) { to.push_back(x.node_of(owner)); }
    template <class Next>
    static real build(const Next& next) {
        return real(next());
    }
};

template <>
struct layout<mask> {
    static type describe() { return {type::truth, nullptr}; }
    static void flatten(const mask& m, tape& owner, std::vector<const node*>& to) {
        const node* zero = owner.number(0.0f);
        to.push_back(m.constant() ? owner.record(op::equal, {zero, owner.number(m.known() ? 0.0f : 1.0f)})
                                  : m.recorded());
    }
    template <class Next>
    static mask build(const Next& next) {
        return mask(next());
    }
};

template <glm::length_t N>
struct layout<glm::vec<N, real, glm::defaultp>> {
    using V = glm::vec<N, real, glm::defaultp>;
    static type describe() { return {N == 2 ? type::vector_2 : type::vector_3, nullptr}; }
    static void flatten(const V& v, tape& owner, std::vector<const node*>& to) {
        for (glm::length_t i = 0; i < N; ++i) to.push_back(v[i].node_of(owner));
    }
    template <class Next>
    static V build(const Next& next) {
        V v;
        for (glm::length_t i = 0; i < N; ++i) v[i] = real(next());
        return v;
    }
};

}  // namespace detail

/// The author's name for a vector.
template <glm::length_t N>
auto named(const char* name, const glm::vec<N, real, glm::defaultp>& v) {
    for (glm::length_t i = 0; i < N; ++i) named(name, v[i]);
    return v;
}

}  // namespace lobe::shader
