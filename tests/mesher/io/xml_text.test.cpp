#include "mesher/io/xml_text.h"

#include <catch2/catch.hpp>

using parmesan::xml_escaped;

TEST_CASE("xml_escaped disarms markup and keeps characters", "[mesher][io]") {
  CHECK(xml_escaped("</script><b a='\"&'>") == "&lt;/script&gt;&lt;b a=&#39;&quot;&amp;&#39;&gt;");
  CHECK(xml_escaped("\xc3\xa9 \xe2\x88\x87u \xf0\x9f\xa7\x80") == "\xc3\xa9 \xe2\x88\x87u \xf0\x9f\xa7\x80");
  CHECK(xml_escaped("").empty());
}

TEST_CASE("xml_escaped replaces what XML cannot hold", "[mesher][io]") {
  CHECK(xml_escaped(std::string_view("a\0b\x1b[2J\x7f", 8)) == "a b [2J ");
  CHECK(xml_escaped("\xff\xc3") == "??");
  CHECK(xml_escaped("\xc0\xaf") == "??");            // overlong
  CHECK(xml_escaped("\xed\xa0\x80") == "???");       // a surrogate
  CHECK(xml_escaped("\xf4\x90\x80\x80") == "????");  // beyond U+10FFFF
  CHECK(xml_escaped("\xe0\x80\xaf") == "???");       // overlong
}
