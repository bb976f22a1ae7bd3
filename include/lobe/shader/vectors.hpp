// Finds what three equal operations on x, y and z do: one operation on a vector.
#pragma once

#include <lobe/shader/function.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace lobe::shader::detail {

using triple = std::array<const node*, 3>;

/// Calls g(type, name, first component) for a value of this type and for everything in it.
template <class G>
void for_each_part(const type& t, const std::string& name, std::uint32_t& component, const G& g) {
    g(t, name, component);
    if (t.kind == type::record) {
        for (const auto& m : t.of->members) for_each_part(m.type, name + "." + m.name, component, g);
    } else {
        component += components(t);
    }
}

/// The nodes that a function needs, each behind its arguments; and the vectors among them.
class vectors {
public:
    explicit vectors(const body& function) : owner(function.nodes) {
        for (const node* root : function.roots) reach(root);
        std::uint32_t component = 0;
        for (const parameter& p : function.parameters)
            for_each_part(p.type, p.name, component, [&](const type& t, const std::string&, std::uint32_t first) {
                if (t.kind == type::vector_3) seed(op::input, first, nullptr);
            });
        for (const call_site* site : sites) {
            component = 0;
            for_each_part(site->callee->result, "", component,
                          [&](const type& t, const std::string&, std::uint32_t first) {
                              if (t.kind == type::vector_3) seed(op::call, first, site);
                          });
        }
        for (std::size_t i = 0; i < groups.size(); ++i) grow(i);
    }

    /// Is any of what is needed this operation?
    bool need(op what) const {
        return std::any_of(reached.begin(), reached.end(), [&](const node* n) { return n->what == what; });
    }

    /// The vector that a node is a component of, and which.
    std::optional<std::pair<std::size_t, int>> vector_of(const node* n) const {
        const auto at = places.find(n);
        return at == places.end() ? std::nullopt : std::optional(at->second);
    }
    const triple& operator[](std::size_t group) const { return groups[group]; }

    /// Is this a vector, its components in order?
    std::optional<std::size_t> find(const triple& t) const {
        const auto place = vector_of(t[0]);
        return place && groups[place->first] == t ? std::optional(place->first) : std::nullopt;
    }
    static bool uniform(const triple& t) { return t[0] == t[1] && t[1] == t[2]; }
    static bool numbers(const triple& t) {
        return std::all_of(t.begin(), t.end(), [](const node* n) { return n->what == op::number; });
    }

    /// The argument of three nodes of one operation.
    static triple argument(const triple& t, std::size_t i) {
        return {t[0]->arguments[i], t[1]->arguments[i], t[2]->arguments[i]};
    }

private:
    void reach(const node* n) {
        if (!n || !reached.insert(n).second) return;
        for (const node* a : n->arguments) reach(a);
        if (n->site) {
            for (const node* a : n->site->arguments) reach(a);
            if (std::find(sites.begin(), sites.end(), n->site) == sites.end()) sites.push_back(n->site);
        }
        for (std::size_t i = 0; i < 3; ++i)
            if (n->arguments[i]) users[n->arguments[i]].push_back(n);
    }

    /// A vector of a parameter or of a result, if any of it is needed.
    void seed(op what, std::uint32_t first, const call_site* site) {
        triple t;
        for (std::uint32_t i = 0; i < 3; ++i) t[i] = owner.find(what, first + i, site);
        if (std::any_of(t.begin(), t.end(), [&](const node* n) { return reached.count(n) > 0; })) add(t);
    }
    void add(const triple& t) {
        for (int i = 0; i < 3; ++i) places.try_emplace(t[static_cast<std::size_t>(i)], groups.size(), i);
        groups.push_back(t);
    }

    /// Vectors that one operation makes of a vector.
    void grow(std::size_t group) {
        const triple from = groups[group];
        for (const node* x : users[from[0]]) {
            if (is_mask(x->what) || places.count(x)) continue;
            for (const node* y : users[from[1]])
                for (const node* z : users[from[2]])
                    if (places.count(x) + places.count(y) + places.count(z) == 0 && alike({x, y, z})) add({x, y, z});
        }
    }
    /// One operation on vectors, on numbers that are the same for all three, and on constants; no component twice.
    bool alike(const triple& t) const {
        if (t[0]->what != t[1]->what || t[1]->what != t[2]->what || t[0] == t[1] || t[1] == t[2] || t[0] == t[2])
            return false;
        for (std::size_t i = 0; i < 3; ++i) {
            const triple a = argument(t, i);
            if (!a[0] || uniform(a)) continue;
            if (is_mask(a[0]->what) || !(numbers(a) || find(a))) return false;
        }
        return true;
    }

    const tape& owner;
    std::set<const node*> reached;
    std::vector<const call_site*> sites;
    std::map<const node*, std::vector<const node*>> users;
    std::map<const node*, std::pair<std::size_t, int>> places;
    std::vector<triple> groups;
};

}  // namespace lobe::shader::detail
