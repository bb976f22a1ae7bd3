// What recording leaves: a graph of operations on numbers of 32 bits, each once.
#pragma once

#include <lobe/core/cpp20.hpp>

#include <array>
#include <bit>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

namespace lobe::shader {

/// What a node of the graph does. `input` is a component of a parameter, `call` one of what a function returns.
enum class op : std::uint8_t {
    number,
    input,
    call,
    add,
    sub,
    mul,
    div,
    neg,
    abs,
    max,
    min,
    sqrt,
    exp,
    exp2,
    expm1,
    log,
    log2,
    log1p,
    pow,
    sin,
    cos,
    tanh,
    acos,
    atan2,
    erfc,
    floor,
    less,
    greater,
    less_equal,
    greater_equal,
    equal,
    both,
    either,
    no,
    select
};

class tape;
struct body;

struct node;

/// A call of a function that was recorded before; its arguments in components.
struct call_site {
    std::shared_ptr<const body> callee;
    std::vector<const node*> arguments;
};

/// One operation. Of `input` and `call`, `index` says which component; of `number`, its bits.
struct node {
    op what;
    std::array<const node*, 3> arguments;
    std::uint32_t index;
    const call_site* site;
    tape* owner;
};

constexpr bool is_mask(op o) { return o >= op::less && o <= op::no; }

/// The owner of the nodes of one function: an operation that it has seen is not recorded again.
class tape {
public:
    tape() = default;
    tape(const tape&) = delete;
    tape& operator=(const tape&) = delete;

    const node* number(float x) { return record(op::number, {}, std::bit_cast<std::uint32_t>(x)); }
    const node* input(std::uint32_t component) { return record(op::input, {}, component); }

    const node* record(op what, std::array<const node*, 3> arguments, std::uint32_t index = 0,
                       const call_site* site = nullptr) {
        const auto [at, is_new] = seen.try_emplace({what, arguments, index, site}, nullptr);
        if (is_new) at->second = &nodes.emplace_back(node{what, arguments, index, site, this});
        return at->second;
    }

    /// An `input` or a `call` that is there, or null.
    const node* find(op what, std::uint32_t index, const call_site* site) const {
        const auto at = seen.find({what, {}, index, site});
        return at == seen.end() ? nullptr : at->second;
    }

    /// The same call of the same function is made once.
    const call_site* call(const std::shared_ptr<const body>& callee, const std::vector<const node*>& arguments) {
        for (const call_site& site : sites)
            if (site.callee == callee && site.arguments == arguments) return &site;
        return &sites.emplace_back(call_site{callee, arguments});
    }

    const std::deque<call_site>& calls() const { return sites; }

    /// The author's name for what a node computes.
    void name(const node* n, const std::string& text) { names.try_emplace(n, text); }
    std::string name_of(const node* n) const {
        const auto at = names.find(n);
        return at == names.end() ? std::string() : at->second;
    }

private:
    std::map<std::tuple<op, std::array<const node*, 3>, std::uint32_t, const call_site*>, const node*> seen;
    std::map<const node*, std::string> names;
    std::deque<node> nodes;
    std::deque<call_site> sites;
};

constexpr float value_of(const node* n) { return std::bit_cast<float>(n->index); }

}  // namespace lobe::shader
