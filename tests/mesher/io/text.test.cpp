#include "mesher/io/text.h"

#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "mesher/errors.h"
#include "tests/mesher/io/error_line.h"
#include "tests/support/temporary_folder.h"

using parmesan::FileError;
using parmesan::read_file;
using parmesan::TextReader;
using parmesan::support::error_line;
using parmesan::support::error_message;
using parmesan::support::TemporaryFolder;

namespace {

const std::string name = "some.txt";

double real_in(const std::string& text) { return TextReader(text, name).real("the number"); }
int integer_in(const std::string& text) { return TextReader(text, name).integer("the number"); }

}  // namespace

TEST_CASE("TextReader reads words between blanks, comments and line ends of any kind", "[mesher][io]") {
  const std::string text = "\xef\xbb\xbf one\ttwo\r\n# a comment\r\n  three#no blank\n\"fo ur\"  5";
  TextReader in(text, name);
  CHECK(in.word("w") == "one");
  CHECK_FALSE(in.at_line_end());
  CHECK(in.word("w") == "two");
  CHECK(in.at_line_end());
  CHECK(in.word("w") == "three");
  CHECK(in.at_line_end());
  CHECK(in.word("w") == "\"fo ur\"");
  CHECK(in.integer("w") == 5);
  CHECK(in.at_end());
}

TEST_CASE("TextReader reads whole numbers to the limits of 32 bits", "[mesher][io]") {
  CHECK(integer_in("0") == 0);
  CHECK(integer_in("+12\n") == 12);
  CHECK(integer_in("-7#x") == -7);
  CHECK(integer_in("123456789") == 123456789);
  CHECK(integer_in("2147483647") == std::numeric_limits<int>::max());
  CHECK(integer_in("-2147483648") == std::numeric_limits<int>::min());
  for (const char* bad : {"2147483648", "-2147483649", "99999999999999999999", "1.0", "1e3", "x", "12x", "+", "-",
                          "--1", "+-1", "0x10", "1,000"}) {
    CAPTURE(bad);
    CHECK_THROWS_AS(integer_in(bad), FileError);
  }
}

TEST_CASE("TextReader reads real numbers to the last bit, whoever wrote them", "[mesher][io]") {
  CHECK(real_in("0.1") == 0.1);
  CHECK(real_in("1.0000000000000002") == 1.0 + std::numeric_limits<double>::epsilon());
  CHECK(real_in("5e-324") == std::numeric_limits<double>::denorm_min());
  CHECK(real_in("-1.7976931348623157e308") == std::numeric_limits<double>::lowest());
  CHECK(std::signbit(real_in("-0")));
  CHECK(real_in("+2.5") == 2.5);
  CHECK(real_in("1.5D-03") == 0.0015);
  CHECK(real_in(".5") == 0.5);
  CHECK(real_in("5.") == 5.0);
  for (const char* bad : {"nan", "inf", "-infinity", "1e999", "0,5", "1.2.3", "one", "1e", "+-1", "0x1p3", ""}) {
    CAPTURE(bad);
    CHECK_THROWS_AS(real_in(bad), FileError);
  }
}

TEST_CASE("TextReader names the line of what it refuses", "[mesher][io][errors]") {
  const std::string text = "1\r\n\n# 3\nx 5\n";
  TextReader in(text, name);
  in.integer("a");
  CHECK(error_line([&in] { in.integer("b"); }) == 4);
  const std::string cut = "1\n2\n";
  TextReader short_in(cut, name);
  short_in.integer("a");
  short_in.integer("b");
  CHECK(error_line([&short_in] { short_in.integer("c"); }) == 3);
  CHECK(error_message([] { real_in("0,5"); }) ==
        "some.txt:1: the number must be a finite number, found '0,5'; the decimal mark is a point");
}

TEST_CASE("TextReader tells values that cannot be from words that are none", "[mesher][io][errors]") {
  using parmesan::FileValueError;
  for (const char* text : {"nan", "-inf", "NaN", "1e999", "-1e400"}) CHECK_THROWS_AS(real_in(text), FileValueError);
  CHECK_THROWS_AS(TextReader("7", name).index("the point", 1, 6), FileValueError);
  for (const char* text : {"", "x", "1,5", "nano"}) {
    CHECK_THROWS_AS(real_in(text), FileError);
    try {
      real_in(text);
    } catch (const FileError& error) {
      CHECK(dynamic_cast<const FileValueError*>(&error) == nullptr);
    }
  }
}

TEST_CASE("TextReader never prints what it does not understand", "[mesher][io][errors]") {
  const std::string message = error_message([] { integer_in("root:x:0:0:\x1b[2J\x01\xff"); });
  CHECK(message == "some.txt:1: the number must be a whole number within 32 bits, found something else");
}

TEST_CASE("TextReader believes counts only as far as the text can hold them", "[mesher][io][errors]") {
  const std::string fits = "2\n1 2\n3 4";
  CHECK(TextReader(fits, name).count("n", 2) == 2);
  const std::string too_many = "3\n1 2\n3 4";
  CHECK(error_line([&] { TextReader(too_many, name).count("n", 2); }) == 1);
  CHECK_THROWS_AS(TextReader("2147483647 1", name).count("n", 2000000000), FileError);
  CHECK_THROWS_AS(TextReader("-1 1", name).count("n", 1), FileError);
}

TEST_CASE("TextReader counts indices from a base", "[mesher][io]") {
  CHECK(TextReader("1", name).index("i", 1, 3) == 0);
  CHECK(TextReader("3", name).index("i", 1, 3) == 2);
  CHECK(TextReader("0", name).index("i", 0, 3) == 0);
  CHECK_THROWS_AS(TextReader("0", name).index("i", 1, 3), FileError);
  CHECK_THROWS_AS(TextReader("4", name).index("i", 1, 3), FileError);
  CHECK_THROWS_AS(TextReader("-2147483648", name).index("i", 1, 3), FileError);
  CHECK_THROWS_AS(TextReader("1", name).index("i", 1, 0), FileError);
  CHECK(error_message([] { TextReader("4", name).index("the corner", 1, 3); }) ==
        "some.txt:1: the corner is 4, must be from 1 to 3");
}

TEST_CASE("TextReader skips to keywords past numbers, strings and nan", "[mesher][io]") {
  const std::string text = "1 2 nan inf \"Quoted word\" 3\nKeyword 4";
  TextReader in(text, name);
  in.skip_to_keyword();
  CHECK(in.word("w") == "Keyword");
  in.skip_to_keyword();
  CHECK(in.at_end());
  CHECK_THROWS_AS(TextReader("\"open", name).word("w"), FileError);
}

TEST_CASE("read_file reads regular files of limited size only", "[mesher][io][errors]") {
  const TemporaryFolder folder;
  const std::string bytes("a\0b\n\xff", 5);
  CHECK(read_file(folder.write("f", bytes)) == bytes);
  CHECK(read_file(folder.write("empty", "")).empty());
  CHECK_THROWS_AS(read_file(folder / "f", 4), FileError);
  CHECK(read_file(folder / "f", 5) == bytes);
  CHECK_THROWS_AS(read_file(folder / "absent"), FileError);
  CHECK_THROWS_AS(read_file(folder / ""), FileError);
  CHECK_THROWS_AS(read_file("/dev/zero"), FileError);
  CHECK_THROWS_AS(read_file(std::string("f\0g", 3)), FileError);
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  CHECK_THROWS_AS(read_file(folder / "pipe"), FileError);
}

TEST_CASE("read_file leaves out the byte order mark of UTF-8", "[mesher][io]") {
  const TemporaryFolder folder;
  CHECK(read_file(folder.write("f", "\xEF\xBB\xBFtext")) == "text");
  CHECK(read_file(folder.write("mark", "\xEF\xBB\xBF")).empty());
  CHECK(read_file(folder.write("g", "\xEF\xBB")) == "\xEF\xBB");
}

TEST_CASE("file_suffix looks at the last dot of the name", "[mesher][io]") {
  CHECK(parmesan::file_suffix("a/b.c/d.MESH") == ".mesh");
  CHECK(parmesan::file_suffix("a.b/c").empty());
  CHECK(parmesan::with_suffix("a.b/c.1.ele", ".node") == "a.b/c.1.node");
  CHECK(parmesan::with_suffix("a.b/c", ".node") == "a.b/c.node");
}
