#include "adapt/json_text.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <string_view>

namespace parmesan {
namespace {

/// What stands in the text from there to the next blank, comma or bracket.
std::string word_at(const std::string& text, std::size_t offset) {
  return text.substr(offset, text.find_first_of(" ,:}]\n", offset) - offset);
}

const std::string kText =
    "\xEF\xBB\xBF{ // first \"a\": 1\n"
    "  \"a\": {\"x/y\": [10, {\"q\": 20}, \"}]\\\"\", [ ]], /* \"b\": { */ \"b\": null},\n"
    "  \"\\u0062\\n\": -3.5e2, \"m~n\": true\n"
    "}";

}  // namespace

TEST_CASE("locate finds names and values through comments, strings and nesting", "[adapt][json]") {
  const auto value = [](const std::string& pointer) { return word_at(kText, locate(kText, pointer).value); };
  CHECK(value("/a/x~1y/0") == "10");
  CHECK(value("/a/x~1y/1/q") == "20");
  CHECK(value("/a/b") == "null");
  CHECK(value("/b\n") == "-3.5e2");
  CHECK(value("/m~0n") == "true");
  CHECK(word_at(kText, locate(kText, "/a/b").key) == "\"b\"");
  CHECK(locate(kText, "/a/b").found);
}

TEST_CASE("locate stops at the nearest parent of what is not there", "[adapt][json]") {
  const JsonPlace place = locate(kText, "/a/x~1y/9/z");
  CHECK_FALSE(place.found);
  CHECK(word_at(kText, place.key) == "\"x/y\"");
  CHECK(locate(kText, "/none").key == 3);
}

constexpr std::size_t many = 100;

TEST_CASE("find_duplicate_keys finds equal names in one object only", "[adapt][json]") {
  CHECK(find_duplicate_keys(kText, many).empty());
  CHECK(find_duplicate_keys(R"({"a": {"a": 1}, "b": [{"a": 1}, {"a": "a"}]})", many).empty());
  const std::string text = R"({"a": 1, "b": [0, {"c": 1, "\u0063": {"d": 1}}], "a": 2})";
  const std::vector<DuplicateKey> duplicates = find_duplicate_keys(text, many);
  REQUIRE(duplicates.size() == 2);
  CHECK(duplicates[0].pointer == "/b/1/c");
  CHECK(word_at(text, duplicates[0].offset) == "\"\\u0063\"");
  CHECK(duplicates[1].pointer == "/a");
  CHECK(find_duplicate_keys(text, 1).size() == 1);
}

TEST_CASE("comments end with a carriage return too, as they do for the parser", "[adapt][json]") {
  const std::string text = "{ // one\r \"a\": 1, // \"a\": two\r\n \"a\": 3 }";
  REQUIRE(nlohmann::json::accept(text, true));
  CHECK(word_at(text, locate(text, "/a").value) == "1");
  CHECK(find_duplicate_keys(text, many).size() == 1);
}

TEST_CASE("find_nesting_beyond finds the bracket that is too deep, in any text", "[adapt][json]") {
  const std::string text = "{\"a\": [{\"b\": \"[[[\"}, // [[[\r [[]]], [";
  CHECK_FALSE(find_nesting_beyond(text, 4));
  CHECK(find_nesting_beyond(text, 3) == text.find("[]"));
  CHECK(find_nesting_beyond(text, 1) == text.find('['));
  CHECK(find_nesting_beyond(std::string(100000, '['), 64) == 64);
  CHECK_FALSE(find_nesting_beyond("]]]]", 1));
}

TEST_CASE("find_names_beyond counts the names of each object for itself", "[adapt][json]") {
  const std::string text = R"({"a": {"b": 1, "c": 2, "d": [{"e": 1}, {"f": 2}]}, "g": "\":", "h": 3})";
  CHECK_FALSE(find_names_beyond(text, 3));
  CHECK(find_names_beyond(text, 2) == text.find("\"d\""));
  CHECK_FALSE(find_names_beyond("}}:::", 0));
}

TEST_CASE("find_overflow finds the number that is too large", "[adapt][json]") {
  const std::string text = R"({"a": [1e308, -1e999, 1e999], "1e999": "1e999"})";
  CHECK(find_overflow(text) == text.find("-1e999"));
  CHECK_FALSE(find_overflow("[1e308, 1e-999, true, null]"));
}

TEST_CASE("line_column counts from 1 and in characters", "[adapt][json]") {
  const std::string text = "ab\n\xC3\xBC\xE2\x82\xACz\n";
  CHECK(line_column(text, 0).column == 1);
  CHECK(line_column(text, 3).line == 2);
  CHECK(line_column(text, 3).column == 1);
  CHECK(line_column(text, 8).column == 3);
  CHECK(line_column(text, 1000).line == 3);
}

TEST_CASE("pointer_steps undoes pointer_step and refuses what is no JSON pointer", "[adapt][json]") {
  const std::string pointer = pointer_step("a/b") + pointer_step("~1") + pointer_step("");
  CHECK(pointer == "/a~1b/~01/");
  CHECK(pointer_steps(pointer) == std::vector<std::string>{"a/b", "~1", ""});
  CHECK(pointer_steps("") == std::vector<std::string>{});
  CHECK_FALSE(pointer_steps("a/b"));
  CHECK_FALSE(pointer_steps("/a~2"));
  CHECK_FALSE(pointer_steps("/a~"));
}

TEST_CASE("what stands behind a NUL, where JSON ends for its reader, has no keys", "[adapt][json]") {
  using namespace std::string_view_literals;
  CHECK(find_duplicate_keys("1 \0.,"sv, 1).empty());
  CHECK(find_duplicate_keys("{} ]},\0"sv, 1).empty());
}

}  // namespace parmesan
