// What a verdict consists of: one check a property, with the worst input and what such a failure usually means.
#pragma once

#include <lobe/testkit/measure/text.hpp>

#include <algorithm>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace lobe::testkit {

/// What a check is, whatever its sentence: `key` is its name in JSON and in code, `text` what a report prints.
struct property_id {
    std::string_view key, text;
    bool about_samples = false;  // where the samples go explains its failure

    friend constexpr bool operator==(const property_id& a, const property_id& b) { return a.key == b.key; }
};

/// A property that does not hold. `input` is C++, with all digits, ready for a unit test.
struct finding {
    property_id id{};
    std::string property;  // the text of its id, as a rule
    double measured = 0, expected = 0, tolerance = 0;
    std::string input;
    std::string meaning;
};

/// A property that was checked: the finding nearest to failing, or failed.
struct check : finding {
    bool passed = true;
};

/// What was found of a property.
struct outcome {
    bool passed = true;
    double measured = 0, expected = 0, tolerance = 0;
    std::string input{};
    std::string meaning{};  // of a failure
    std::string suffix{};   // follows the property's text
};

namespace detail {

inline std::string quoted(const std::string& text) {
    constexpr std::string_view hex = "0123456789abcdef";
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\')
            out += std::string("\\") + c;
        else if (static_cast<unsigned char>(c) < 0x20) {
            out +=
                {'\\', 'u', '0', '0', hex[static_cast<unsigned char>(c) / 16], hex[static_cast<unsigned char>(c) % 16]};
        } else
            out += c;
    }
    return out + '"';
}

/// Text inside an XML attribute or element. XML 1.0 has no form for control characters: they become spaces.
inline std::string xml_text(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else if (c == '"')
            out += "&quot;";
        else
            out += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
    }
    return out;
}

/// JSON knows no NaN and no infinity: they are null.
inline std::string json_number(double x) { return is_finite(x) ? number(x, 17) : "null"; }

}  // namespace detail

/// Everything that was checked of one subject. Tests as true if all of it passed.
class report {
public:
    explicit report(std::string subject) : name_(std::move(subject)) {}

    void add(check result) { checks_.push_back(std::move(result)); }
    void add(const property_id& id, outcome o) {
        checks_.push_back({{id, std::string(id.text) + o.suffix, o.measured, o.expected, o.tolerance,
                            std::move(o.input), std::move(o.meaning)},
                           o.passed});
    }

    const std::string& name() const { return name_; }
    const std::vector<check>& checks() const { return checks_; }
    std::vector<finding> findings() const {
        std::vector<finding> failed;
        for (const check& c : checks_)
            if (!c.passed) failed.push_back(c);
        return failed;
    }
    bool passed() const {
        return std::all_of(checks_.begin(), checks_.end(), [](const check& c) { return c.passed; });
    }
    explicit operator bool() const { return passed(); }

    std::string json() const {
        std::string out = "{\"subject\": " + detail::quoted(name_) + ", \"passed\": " + (passed() ? "true" : "false") +
                          ", \"checks\": [";
        for (std::size_t i = 0; i < checks_.size(); ++i) {
            const check& c = checks_[i];
            out += (i ? ",\n  " : "\n  ") + ("{\"id\": " + detail::quoted(std::string(c.id.key))) +
                   ", \"property\": " + detail::quoted(c.property) + ", \"passed\": " + (c.passed ? "true" : "false") +
                   ", \"measured\": " + detail::json_number(c.measured) +
                   ", \"expected\": " + detail::json_number(c.expected) +
                   ", \"tolerance\": " + detail::json_number(c.tolerance) + ", \"input\": " + detail::quoted(c.input) +
                   ", \"meaning\": " + detail::quoted(c.passed ? "" : c.meaning) + "}";
        }
        return out + "]}\n";
    }

    /// As JUnit writes tests, which build servers read: a suite of one test a check. Several: junit(reports).
    std::string junit() const;

    /// The table that << prints.
    std::string text() const {
        const auto padded = [](std::string text, std::size_t width) {
            text.resize((std::max)(width, text.size()), ' ');
            return text;
        };
        std::size_t widest = 8;
        for (const check& c : checks_) widest = (std::max)(widest, c.property.size());
        std::string out = (name_.empty() ? "" : name_ + ": ") + (passed() ? "passed" : "FAILED") + "\n  " +
                          padded("property", widest) + "            measured      expected     tolerance\n";
        for (const check& c : checks_) {
            out += "  " + padded(c.property, widest) + (c.passed ? "  ok      " : "  FAILED  ");
            for (const double x : {c.measured, c.expected, c.tolerance}) {
                const std::string text = detail::number(x);
                out += std::string(text.size() < 12 ? 12 - text.size() : 0, ' ') + text + "  ";
            }
            out += '\n';
            if (!c.passed && !c.meaning.empty()) out += "      " + c.meaning + '\n';
            if (!c.passed && !c.input.empty()) out += "      at  " + c.input + '\n';
        }
        return out;
    }
    friend std::ostream& operator<<(std::ostream& out, const report& r) { return out << r.text(); }

private:
    std::string name_;
    std::vector<check> checks_;
};

/// The reports of several subjects as one file of JUnit.
inline std::string junit(const std::vector<report>& all) {
    using detail::number, detail::xml_text;
    std::string out = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
    for (const report& r : all) {
        const std::string suite = xml_text(r.name().empty() ? "lobe" : r.name());
        out += "  <testsuite name=\"" + suite + "\" tests=\"" + std::to_string(r.checks().size()) + "\" failures=\"" +
               std::to_string(r.findings().size()) + "\" errors=\"0\">\n";
        for (const check& c : r.checks()) {
            out += "    <testcase classname=\"" + suite + "\" name=\"" + xml_text(c.property) + "\"";
            if (c.passed) {
                out += "/>\n";
                continue;
            }
            out += ">\n      <failure type=\"" + xml_text(c.id.key) + "\" message=\"" + xml_text(c.meaning) +
                   "\">measured " + number(c.measured) + ", expected " + number(c.expected) + ", tolerance " +
                   number(c.tolerance) + (c.input.empty() ? "" : "\nat  " + xml_text(c.input)) +
                   "</failure>\n    </testcase>\n";
        }
        out += "  </testsuite>\n";
    }
    return out + "</testsuites>\n";
}

inline std::string report::junit() const { return testkit::junit({*this}); }

}  // namespace lobe::testkit
