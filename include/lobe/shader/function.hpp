// A function of a shader: a name, named parameters, and a lambda that is run once, on numbers that record.
#pragma once

#include <lobe/shader/types.hpp>

namespace lobe::shader {

struct parameter {
    std::string name;
    shader::type type;
};

/// A recorded function, whatever its types.
struct body {
    std::string name, about;
    std::vector<parameter> parameters;
    type result;
    std::vector<const node*> roots;  // of the components of the result
    std::vector<glm::vec2> values;   // of a table, which is a function of an index
    tape nodes;
};

namespace detail {

template <class Call>
struct signature_of;
template <class F, class R, class... A>
struct signature_of<R (F::*)(A...) const> {
    using result = std::remove_cvref_t<R>;
    using arguments = std::tuple<std::remove_cvref_t<A>...>;
};
template <class F>
using signature = signature_of<decltype(&F::operator())>;

}  // namespace detail

template <class R, class Arguments>
class recorded;

/// What `function` returns. Called from the lambda of another function it records a call of this one.
template <class R, class... A>
class recorded<R, std::tuple<A...>> {
public:
    template <class F>
    recorded(const std::string& name, const std::vector<const char*>& names, const F& f)
        : content(std::make_shared<body>()) {
        if (names.size() != sizeof...(A)) throw std::invalid_argument(name + ": a name for each parameter");
        content->name = name;
        content->result = detail::layout<R>::describe();
        const type types[] = {detail::layout<A>::describe()...};
        for (std::size_t i = 0; i < sizeof...(A); ++i) content->parameters.push_back({names[i], types[i]});
        std::uint32_t component = 0;
        const auto next = [&] { return content->nodes.input(component++); };
        const std::tuple<A...> arguments{detail::layout<A>::build(next)...};  // braces: from left to right
        detail::layout<R>::flatten(std::apply(f, arguments), content->nodes, content->roots);
    }

    R operator()(const A&... arguments) const {
        tape constants;
        std::vector<const node*> flat;
        (detail::layout<A>::flatten(arguments, constants, flat), ...);
        tape* owner = nullptr;
        for (const node* n : flat)
            if (n->owner != &constants) owner = n->owner;
        if (!owner)
            throw std::invalid_argument(content->name + ": called with constants alone; compute that on the host");
        for (const node*& n : flat)
            if (n->owner == &constants) n = owner->record(n->what, n->arguments, n->index);
        const call_site* site = owner->call(content, flat);
        std::uint32_t component = 0;
        return detail::layout<R>::build([&] { return owner->record(op::call, {}, component++, site); });
    }

    /// Lines of the comment above the printed function: what it is, its source, domain, error.
    recorded about(const std::string& text) const {
        content->about = text;
        return *this;
    }

    /// A table: what the function of an index returns is not what was recorded, but one of these.
    recorded reading(const std::vector<glm::vec2>& values) const {
        content->values = values;
        return *this;
    }

    std::shared_ptr<const body> recording() const { return content; }

private:
    std::shared_ptr<body> content;
};

/// `function("gold", {"v", "l", "roughness"}, [](vec3 v, vec3 l, real roughness) { ... })`, with `real` and `vec3`
/// those of this namespace. Values that the lambda captures are constants of the shader.
template <class F>
auto function(const std::string& name, const std::vector<const char*>& parameters, const F& f) {
    using s = detail::signature<F>;
    return recorded<typename s::result, typename s::arguments>(name, parameters, f);
}

using vec2 = lobe::vec2<real>;
using vec3 = lobe::vec3<real>;

}  // namespace lobe::shader
