// The report as JUnit writes tests, read by somebody else's parser.
#include "catch.hpp"

#include <lobe/testkit.hpp>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <sstream>
#include <string>

using namespace lobe::testkit;

namespace {

using tree = boost::property_tree::ptree;

tree parsed(const std::string& xml) {
    std::istringstream in(xml);
    tree out;
    boost::property_tree::read_xml(in, out);
    return out;
}
std::string attribute(const tree& node, const char* name) {
    return node.get<std::string>(std::string("<xmlattr>.") + name);
}

report verdict_on(double albedo, std::string name) {
    options o;
    o.name = std::move(name);
    const auto matt = [albedo](glm::dvec3 v, glm::dvec3 l) {
        return v.z > 0 && l.z > 0 ? albedo * l.z / 3.14159265 : 0;
    };
    return verify(matt, o);
}

}  // namespace

TEST_CASE("JUnit: a suite a subject, a test a property, read back", "[testkit]") {
    const report good = verdict_on(0.5, ""), bad = verdict_on(2, "two \"and\" <more> & \x01 \xc3\xa9");
    REQUIRE(good.passed());
    REQUIRE(bad.findings().size() == 2);
    const tree suites = parsed(junit({good, bad})).get_child("testsuites");
    REQUIRE(suites.count("testsuite") == 2);

    const report* of = &good;
    for (const auto& [tag, suite] : suites) {
        CHECK(tag == "testsuite");
        CHECK(attribute(suite, "name") == (of == &good ? "lobe" : "two \"and\" <more> &   \xc3\xa9"));
        CHECK(attribute(suite, "tests") == std::to_string(of->checks().size()));
        CHECK(attribute(suite, "failures") == std::to_string(of->findings().size()));
        CHECK(suite.count("testcase") == of->checks().size());
        std::size_t i = 0;
        for (const auto& [what, test] : suite) {
            if (what != "testcase") continue;
            const check& c = of->checks()[i++];
            CHECK(attribute(test, "name") == c.property);
            CHECK(test.count("failure") == (c.passed ? 0 : 1));
            if (c.passed) continue;
            const tree& failure = test.get_child("failure");
            CHECK(attribute(failure, "type") == c.id.key);
            CHECK(attribute(failure, "message") == c.meaning);
            CHECK(failure.data().find(c.input) != std::string::npos);
        }
        of = &bad;
    }
    CHECK(bad.junit() == junit({bad}));
    CHECK(parsed(junit({})).count("testsuites") == 1);
}
