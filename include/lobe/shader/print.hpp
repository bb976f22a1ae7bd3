// Writes recorded functions in a shading language.
#pragma once

#include <lobe/shader/functions.hpp>
#include <lobe/shader/language.hpp>
#include <lobe/shader/vectors.hpp>
#include <lobe/version.hpp>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <sstream>

namespace lobe::shader {

namespace detail {

inline std::string in(const language& to, const type& t) {
    switch (t.kind) {
        case type::vector_2: return to.vector_2;
        case type::vector_3: return to.vector_3;
        case type::truth: return to.truth;
        case type::record: return t.of->name;
        default: return to.number;
    }
}

/// The shortest text that reads back to the same bits, also by way of a double.
inline std::string literal(float x, const std::string& suffix) {
    if (!std::isfinite(x)) throw std::invalid_argument("a constant that is infinite or NaN has no literal in a shader");
    char text[40];
    std::string s(text, std::to_chars(text, text + sizeof text, x).ptr);
    const double read =
        std::strtod(s.c_str(), nullptr);  // WGSL refuses what is above the largest float before rounding
    if (static_cast<float>(read) != x || std::abs(read) > std::numeric_limits<float>::max())  // house: bits
        s.assign(text, std::to_chars(text, text + sizeof text, static_cast<double>(x)).ptr);
    if (s.find_first_of(".e") == std::string::npos) s += ".0";
    return s + suffix;
}

/// How tightly an operator binds.
enum binding { loosest, choice, disjunction, conjunction, comparison, sum, product, sign, atom };

struct text {
    std::string code;
    binding binds = atom;
    std::string at_least(binding wanted) const { return binds >= wanted ? code : "(" + code + ")"; }
};

struct infix {
    const char* sign;
    binding binds;
};
inline const infix* infix_of(op what) {
    static constexpr std::pair<op, infix> all[] = {{op::add, {" + ", sum}},
                                                   {op::sub, {" - ", sum}},
                                                   {op::mul, {" * ", product}},
                                                   {op::div, {" / ", product}},
                                                   {op::less, {" < ", comparison}},
                                                   {op::greater, {" > ", comparison}},
                                                   {op::less_equal, {" <= ", comparison}},
                                                   {op::greater_equal, {" >= ", comparison}},
                                                   {op::equal, {" == ", comparison}},
                                                   {op::both, {" && ", conjunction}},
                                                   {op::either, {" || ", disjunction}}};
    for (const auto& [o, i] : all)
        if (o == what) return &i;
    return nullptr;
}

inline const char* name_of(op what) {
    static constexpr std::pair<op, const char*> all[] = {
        {op::abs, "abs"},     {op::max, "max"},     {op::min, "min"},    {op::sqrt, "sqrt"}, {op::exp, "exp"},
        {op::exp2, "exp2"},   {op::expm1, "expm1"}, {op::log, "log"},    {op::log2, "log2"}, {op::log1p, "log1p"},
        {op::pow, "pow"},     {op::sin, "sin"},     {op::cos, "cos"},    {op::tanh, "tanh"}, {op::acos, "acos"},
        {op::atan2, "atan2"}, {op::erfc, "erfc"},   {op::floor, "floor"}};
    for (const auto& [o, name] : all)
        if (o == what) return name;
    return "";
}

/// The text of one function.
class writer {
public:
    writer(const body& recorded, const language& language_) : function(recorded), to(language_), known(recorded) {}

    std::string write() {
        if (free_name(function.name) != function.name)
            throw std::invalid_argument(function.name + " is a word of " + to.name +
                                        ": choose another name for the function");
        if (!function.values.empty()) return table();
        std::string parameters;
        for (const parameter& p : function.parameters) {
            const std::string name = free_name(p.name);
            given.push_back(name);
            parameters +=
                (parameters.empty() ? "" : ", ") + filled(to.parameter, {{"type", in(to, p.type)}, {"name", name}});
        }
        std::uint32_t component = 0;
        const std::vector<std::size_t> result = parts_of(function.result, function.roots, component);
        for (const std::size_t v : result) use(v);
        std::string last;
        for (const std::size_t v : result) last += (last.empty() ? "" : ", ") + inlined(v).code;
        last = filled(function.result.kind == type::record ? to.returned : "    return $value;\n",
                      {{"type", in(to, function.result)}, {"value", last}});
        return filled(to.function,
                      {{"type", in(to, function.result)}, {"name", function.name}, {"parameters", parameters}}) +
               lines + last + "}\n";
    }

private:
    /// A table of pairs and the function that reads it, by an index that is a whole number.
    std::string table() const {
        std::string pairs;
        for (std::size_t i = 0; i < function.values.size(); ++i)
            pairs += (i ? "," : "") + std::string(i % 4 ? " " : "\n    ") +
                     filled(to.pair, {{"type", to.vector_2},
                                      {"x", literal(function.values[i].x, to.suffix)},
                                      {"y", literal(function.values[i].y, to.suffix)}});
        return filled(to.table, {{"type", to.vector_2},
                                 {"array", function.name + "_values"},
                                 {"name", function.name},
                                 {"size", std::to_string(function.values.size())},
                                 {"pairs", pairs}});
    }

    /// What the text consists of: an operation on numbers or on vectors, a part of a parameter or of a result.
    struct value {
        enum kinds { operation, dot, construct, number, part, call, component } kind;
        op what{};
        std::vector<std::size_t> arguments{};
        shader::type type{};
        std::string name{};  // of the author, or of a part
        float constant{};
        const call_site* site{};
        int index{};
        int uses = 0;
        std::string variable{};
    };

    // ---- values

    std::size_t made(value v) {
        values.push_back(std::move(v));
        return values.size() - 1;
    }

    /// The values that make up a type, given its components.
    std::vector<std::size_t> parts_of(const type& t, const std::vector<const node*>& from, std::uint32_t& component) {
        if (t.kind == type::record) {
            std::vector<std::size_t> all;
            for (const auto& m : t.of->members) all.push_back(whole(m.type, from, component));
            return all;
        }
        return {whole(t, from, component)};
    }
    std::size_t whole(const type& t, const std::vector<const node*>& from, std::uint32_t& component) {
        if (t.kind == type::record) {
            if (const auto same = unchanged(t, from, component)) return *same;
            return made({.kind = value::construct, .arguments = parts_of(t, from, component), .type = t});
        }
        const std::uint32_t first = component;
        component += components(t);
        if (t.kind == type::vector_3) {
            const triple all{from[first], from[first + 1], from[first + 2]};
            return vectors::uniform(all) ? made({.kind = value::construct, .arguments = {of(all[0])}, .type = t})
                                         : of(all);
        }
        if (t.kind == type::vector_2) {
            if (const auto same = unchanged(t, from, first)) return *same;
            return made({.kind = value::construct, .arguments = {of(from[first]), of(from[first + 1])}, .type = t});
        }
        return of(from[first]);
    }
    /// A parameter, or a part of it, that is passed on as it is.
    std::optional<std::size_t> unchanged(const type& t, const std::vector<const node*>& from, std::uint32_t first) {
        for (std::uint32_t i = 0; i < components(t); ++i)
            if (from[first + i]->what != op::input || from[first + i]->index != from[first]->index + i)
                return std::nullopt;
        std::optional<std::size_t> found;
        each_part(*from[first], [&](const type& u, const std::string& name, std::uint32_t at) {
            if (u.kind == t.kind && at == from[first]->index && !found)
                found = made({.kind = value::part, .type = u, .name = name});
        });
        return found;
    }

    /// Calls g with the parts of what an `input` or a `call` belongs to.
    template <class G>
    void each_part(const node& n, const G& g) const {
        std::uint32_t component = 0;
        if (n.what == op::input)
            for (std::size_t i = 0; i < given.size(); ++i)
                for_each_part(function.parameters[i].type, given[i], component, g);
        else
            for_each_part(n.site->callee->result, "", component, g);
    }

    std::size_t of(const node* n) {
        if (const auto at = of_node.find(n); at != of_node.end()) return at->second;
        const std::size_t v = make(n);
        of_node.emplace(n, v);
        return v;
    }
    std::size_t make(const node* n) {
        if (n->what == op::number) return made({.kind = value::number, .constant = value_of(n)});
        const auto vector = known.vector_of(n);
        if (vector && n->what != op::input && n->what != op::call) {
            const std::size_t whole_vector = of(known[vector->first]);
            return made({.kind = value::component, .arguments = {whole_vector}, .index = vector->second});
        }
        if (n->what == op::input || n->what == op::call) return part(n);
        if (const auto factors = dot_product(n))
            return made({.kind = value::dot, .arguments = {of(factors->first), of(factors->second)}, .name = named(n)});
        value v{.kind = value::operation,
                .what = n->what,
                .type = {is_mask(n->what) ? type::truth : type::number, {}},
                .name = named(n)};
        for (const node* a : n->arguments)
            if (a) v.arguments.push_back(of(a));
        return made(v);
    }

    /// A number of a parameter or of a result: `v.x`, `material.roughness`.
    std::size_t part(const node* n) {
        std::string path;
        shader::type found;
        each_part(*n, [&](const type& t, const std::string& name, std::uint32_t first) {
            if (t.kind == type::record || n->index < first || n->index >= first + components(t)) return;
            const char* component[] = {".x", ".y", ".z"};
            const bool vector = t.kind == type::vector_2 || t.kind == type::vector_3;
            path = name + (vector ? component[n->index - first] : "");
            found = t;
        });
        const shader::type scalar{found.kind == type::truth ? type::truth : type::number, {}};
        if (n->what == op::input) return made({.kind = value::part, .type = scalar, .name = path});
        return made({.kind = value::part, .arguments = {called(n->site)}, .type = scalar, .name = path});
    }
    std::size_t called(const call_site* site) {
        if (const auto at = of_call.find(site); at != of_call.end()) return at->second;
        value v{.kind = value::call, .type = site->callee->result, .name = site->callee->name, .site = site};
        std::uint32_t component = 0;
        for (const parameter& p : site->callee->parameters)
            v.arguments.push_back(whole(p.type, site->arguments, component));
        return of_call.emplace(site, made(v)).first->second;
    }

    /// A vector; one number for all three is that number.
    std::size_t of(const triple& t) {
        if (vectors::uniform(t)) return of(t[0]);
        if (const auto at = of_triple.find(t); at != of_triple.end()) return at->second;
        const std::size_t v = make(t);
        of_triple.emplace(t, v);
        return v;
    }
    std::size_t make(const triple& t) {
        const shader::type vec{type::vector_3, {}};
        if (!known.find(t)) {
            return made({.kind = value::construct,
                         .arguments = {of(t[0]), of(t[1]), of(t[2])},
                         .type = vec,
                         .name = named(t[0])});
        }
        if (t[0]->what == op::input || t[0]->what == op::call) {
            std::string path;
            each_part(*t[0], [&](const type& u, const std::string& name, std::uint32_t first) {
                if (u.kind == type::vector_3 && first == t[0]->index) path = name;
            });
            if (t[0]->what == op::input) return made({.kind = value::part, .type = vec, .name = path});
            const std::size_t from = called(t[0]->site);
            return path.empty() ? from : made({.kind = value::part, .arguments = {from}, .type = vec, .name = path});
        }
        value v{.kind = value::operation, .what = t[0]->what, .type = vec, .name = named(t[0])};
        for (std::size_t i = 0; i < 3; ++i)
            if (t[0]->arguments[i]) v.arguments.push_back(of(vectors::argument(t, i)));
        return made(v);
    }

    /// a.x b.x + a.y b.y + a.z b.z, in this order.
    std::optional<std::pair<triple, triple>> dot_product(const node* n) const {
        if (n->what != op::add || n->arguments[0]->what != op::add) return std::nullopt;
        const triple products{n->arguments[0]->arguments[0], n->arguments[0]->arguments[1], n->arguments[1]};
        for (const node* p : products)
            if (p->what != op::mul) return std::nullopt;
        const triple a = vectors::argument(products, 0), b = vectors::argument(products, 1);
        return known.find(a) && known.find(b) ? std::optional(std::pair(a, b)) : std::nullopt;
    }

    std::string named(const node* n) const { return function.nodes.name_of(n); }

    // ---- text

    void use(std::size_t v) {
        const bool through = values[v].kind == value::part || values[v].kind == value::component;  // has no variable
        if (values[v].uses++ && !through) return;
        for (const std::size_t a : values[v].arguments) use(a);
    }

    /// The value where it is used: its variable, if it has or deserves one, else its own text.
    text inlined(std::size_t v) {
        if (!values[v].variable.empty()) return {values[v].variable};
        const auto kind = values[v].kind;
        const bool trivial = kind == value::number || kind == value::part || kind == value::component;
        if (trivial) return expression(v);
        text e = expression(v);
        return values[v].uses > 1 || (!values[v].name.empty() && kind != value::call) ? declared(v, e) : e;
    }
    text declared(std::size_t v, const text& e) {
        value& x = values[v];
        const bool own = !x.name.empty() && x.kind != value::call;
        const char letter = x.type.kind == type::truth    ? 'b'
                            : x.type.kind == type::number ? 't'
                            : x.type.kind == type::record ? 's'
                                                          : 'w';
        x.variable = own ? free_name(x.name) : free_name(letter + std::to_string(++count[letter]));
        lines +=
            "    " + filled(to.declaration, {{"type", in(to, x.type)}, {"name", x.variable}, {"value", e.code}}) + "\n";
        return {x.variable};
    }
    /// ... as an operand, which is kept short.
    text operand(std::size_t v) {
        const text e = inlined(v);
        if (!values[v].variable.empty() || (e.code.size() <= 44 && e.binds != choice)) return e;
        const auto kind = values[v].kind;
        return kind == value::part || kind == value::number || kind == value::component ? e : declared(v, e);
    }
    /// ... where a vector is wanted.
    std::string as_vector(std::size_t v, const text& e) const {
        return values[v].type.kind == type::vector_3 ? e.code
                                                     : filled(to.splat, {{"type", to.vector_3}, {"value", e.code}});
    }

    text expression(std::size_t v) {
        const value x = values[v];
        switch (x.kind) {
            case value::number: return {literal(x.constant, to.suffix), std::signbit(x.constant) ? sign : atom};
            case value::part: {
                if (x.arguments.empty()) return {x.name};
                const std::size_t from = x.arguments[0];
                if (x.name.empty()) return inlined(from);
                const text base = inlined(from);
                return {(values[from].variable.empty() ? declared(from, base) : base).code + x.name};
            }
            case value::component: {
                const std::size_t from = x.arguments[0];
                const text base = inlined(from);
                const bool simple = !values[from].variable.empty() || values[from].kind == value::part;
                return {(simple ? base : declared(from, base)).code + (x.index == 0   ? ".x"
                                                                       : x.index == 1 ? ".y"
                                                                                      : ".z")};
            }
            case value::dot: return {"dot(" + operand(x.arguments[0]).code + ", " + operand(x.arguments[1]).code + ")"};
            case value::call: {
                std::string arguments;
                for (const std::size_t a : x.arguments) arguments += (arguments.empty() ? "" : ", ") + operand(a).code;
                return {x.name + "(" + arguments + ")"};
            }
            case value::construct: {
                std::string parts;
                for (const std::size_t a : x.arguments) parts += (parts.empty() ? "" : ", ") + operand(a).code;
                if (x.type.kind == type::record)
                    throw std::invalid_argument("a struct inside a result or an argument has to be one that was given");
                if (x.arguments.size() == 1) return {filled(to.splat, {{"type", in(to, x.type)}, {"value", parts}})};
                return {in(to, x.type) + "(" + parts + ")"};
            }
            default: return operation(x);
        }
    }

    text operation(const value& x) {
        const auto arg = [&](std::size_t i) { return operand(x.arguments[i]); };
        if (const infix* i = infix_of(x.what)) {
            const text left = arg(0), right = arg(1);
            const bool logical = i->binds == conjunction || i->binds == disjunction;  // WGSL wants them in parentheses
            const auto tighter = static_cast<binding>(i->binds + 1);
            const binding on_left = logical && left.binds != i->binds ? comparison
                                    : i->binds == comparison          ? sum
                                                                      : i->binds;
            return {left.at_least(on_left) + i->sign + right.at_least(logical ? comparison : tighter), i->binds};
        }
        if (x.what == op::neg) return {"-" + arg(0).at_least(atom), sign};
        if (x.what == op::no) return {"!" + arg(0).at_least(atom), sign};
        const bool vector = x.type.kind == type::vector_3;
        if (x.what == op::select) {
            const text m = arg(0), a = arg(1), b = arg(2);
            const auto side = [&](std::size_t i, const text& e) {
                return vector ? as_vector(x.arguments[i], e) : e.at_least(disjunction);
            };
            const bool is_ternary = to.choice.find('?') != std::string::npos;
            return {filled(to.choice, {{"mask", m.at_least(disjunction)}, {"a", side(1, a)}, {"b", side(2, b)}}),
                    is_ternary ? choice : atom};
        }
        std::string name = name_of(x.what), arguments;
        for (const auto& [what, other] : to.calls)
            if (what == x.what) name = other;
        for (std::size_t i = 0; i < x.arguments.size(); ++i) {
            const text e = arg(i);
            arguments += (i ? ", " : "") + (vector ? as_vector(x.arguments[i], e) : e.code);
        }
        return {name + "(" + arguments + ")"};
    }

    /// A name that nothing else has.
    std::string free_name(std::string name) {
        for (const std::string_view word : to.reserved)
            if (word == name) name += "_";
        const std::string wanted = name;
        for (int i = 2; !taken.insert(name).second; ++i) name = wanted + "_" + std::to_string(i);
        return name;
    }

    const body& function;
    const language& to;
    vectors known;
    std::vector<std::string> given;  // names of parameters as written
    std::vector<value> values;
    std::map<const node*, std::size_t> of_node;
    std::map<triple, std::size_t> of_triple;
    std::map<const call_site*, std::size_t> of_call;
    std::set<std::string> taken;
    std::map<char, int> count;
    std::string lines;
};

}  // namespace detail

/// Functions for one file; those that they call come with them.
class file {
public:
    template <class R, class A>
    file& add(const recorded<R, A>& f) {
        add(f.recording());
        return *this;
    }

    const std::vector<std::shared_ptr<const body>>& functions() const { return bodies; }

    /// The text: a comment, structs, what the language lacks, functions.
    std::string print(const language& to, const std::string& about = {}) const {
        std::string text =
            comment("Written by lobe " + std::string(version) + (about.empty() ? "" : "\n" + about)) + to.preamble;
        for (const auto& s : structures()) {
            std::string members;
            for (const auto& m : s->members)
                members +=
                    "    " + detail::filled(to.member, {{"type", detail::in(to, m.type)}, {"name", m.name}}) + "\n";
            text += "\nstruct " + s->name + " {\n" + members + to.structure_end;
        }
        std::vector<std::shared_ptr<const body>> all;
        for (const op what : to.missing)
            if (uses(what)) all.push_back(replacement(what));
        all.insert(all.end(), bodies.begin(), bodies.end());
        for (const auto& b : all)
            text += "\n" + (b->about.empty() ? "" : comment(b->about)) + detail::writer(*b, to).write();
        return text + to.end;
    }

private:
    static std::string comment(const std::string& text) {
        std::istringstream from(text);
        std::string line, result;
        while (std::getline(from, line)) result += line.empty() ? "//\n" : "// " + line + "\n";
        return result;
    }

    void add(const std::shared_ptr<const body>& b) {
        for (const auto& known : bodies) {
            if (known == b) return;
            if (known->name == b->name) throw std::invalid_argument("two functions are called " + b->name);
        }
        for (const call_site& site : b->nodes.calls()) add(site.callee);
        bodies.push_back(b);
    }

    static std::shared_ptr<const body> replacement(op what) {
        if (what == op::log1p) return detail::log1p_function().about("ln(1 + x)").recording();
        if (what == op::expm1) return detail::expm1_function().about("exp(x) - 1").recording();
        if (what == op::tanh) return detail::tanh_function().about("tanh(x), right near 0 as well").recording();
        return detail::erfc_function().about("The complementary error function.").recording();
    }

    bool uses(op what) const {
        return std::any_of(bodies.begin(), bodies.end(), [&](const auto& b) { return detail::vectors(*b).need(what); });
    }

    std::vector<std::shared_ptr<const structure>> structures() const {
        std::vector<std::shared_ptr<const structure>> all;
        const auto collect = [&](const auto& self, const type& t) -> void {
            if (t.kind != type::record) return;
            for (const auto& m : t.of->members) self(self, m.type);
            for (const auto& s : all)
                if (s->name == t.of->name) return;
            all.push_back(t.of);
        };
        for (const auto& b : bodies) {
            for (const parameter& p : b->parameters) collect(collect, p.type);
            collect(collect, b->result);
        }
        return all;
    }

    std::vector<std::shared_ptr<const body>> bodies;
};

}  // namespace lobe::shader
