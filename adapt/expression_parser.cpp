#include <array>
#include <utility>

#include "adapt/expression.h"
#include "adapt/expression_functions.h"
#include "adapt/expression_lexer.h"
#include "adapt/expression_names.h"
#include "adapt/expression_tape.h"
#include "adapt/tape_writer.h"

namespace parmesan {
namespace {

struct Operator {
  std::string_view symbol;
  Op op;
};

/// Operators that associate to the left, by level, loosest first.
using Level = std::array<Operator, 4>;
constexpr std::array<Level, 6> kLevels{{
    {{{"||", Op::Or}, {}, {}, {}}},
    {{{"&&", Op::And}, {}, {}, {}}},
    {{{"==", Op::Equal}, {"!=", Op::NotEqual}, {}, {}}},
    {{{"<", Op::Less}, {"<=", Op::LessEqual}, {">", Op::Greater}, {">=", Op::GreaterEqual}}},
    {{{"+", Op::Add}, {"-", Op::Subtract}, {}, {}}},
    {{{"*", Op::Multiply}, {"/", Op::Divide}, {}, {}}},
}};
constexpr std::size_t kEqualityLevel = 2;
constexpr std::size_t kComparisonLevel = 3;

/// Recursive descent; every recursion that the text controls passes through Nested.
class Parser {
 public:
  Parser(std::vector<Token> tokens, const ExpressionNames& names)
      : tokens_(std::move(tokens)), names_(names), writer_(names.num_extra()) {}

  Tape parse() {
    choice();
    if (!at_end()) unexpected_after_value();
    return std::move(writer_).finish();
  }

 private:
  class Nested {
   public:
    explicit Nested(Parser& parser) : parser_(parser) {
      if (++parser_.depth_ > kMaxExpressionDepth) {
        parser_.fail("the expression is nested more than " + std::to_string(kMaxExpressionDepth) + " deep");
      }
    }
    ~Nested() { --parser_.depth_; }
    Nested(const Nested&) = delete;
    Nested& operator=(const Nested&) = delete;

   private:
    Parser& parser_;
  };

  const Token& token() const { return tokens_[next_]; }
  bool at_end() const { return token().kind == TokenKind::End; }
  bool at(std::string_view symbol) const { return token().kind == TokenKind::Symbol && token().text == symbol; }

  bool accept(std::string_view symbol) {
    if (!at(symbol)) return false;
    ++next_;
    return true;
  }

  void expect(std::string_view symbol, const std::string& purpose) {
    if (!accept(symbol)) fail("'" + std::string(symbol) + "' expected " + purpose + ", found " + found());
  }

  std::string found() const { return at_end() ? "the end" : "'" + std::string(token().text.substr(0, 40)) + "'"; }

  [[noreturn]] void fail(const std::string& message) const { throw ExpressionError(token().position, message); }

  [[noreturn]] void unexpected_after_value() const {
    if (at(")")) fail("')' has no matching '('");
    if (at(",")) fail("',' only separates the arguments of a function");
    if (at(":")) fail("':' has no matching '?'");
    fail("an operator is missing before " + found());
  }

  void choice() {
    binary(0);
    if (!accept("?")) return;
    const Nested nested(*this);
    const std::size_t to_second = writer_.jump(Op::JumpIfZero);
    choice();
    expect(":", "between the two choices of '?'");
    const std::size_t to_end = writer_.jump(Op::Jump);
    writer_.land(to_second);
    choice();
    writer_.land(to_end);
  }

  const Operator* operator_at(std::size_t level) const {
    for (const Operator& candidate : kLevels[level]) {
      if (!candidate.symbol.empty() && at(candidate.symbol)) return &candidate;
    }
    return nullptr;
  }

  void binary(std::size_t level) {
    if (level == kLevels.size()) return sign();
    binary(level + 1);
    const bool comparing = level == kEqualityLevel || level == kComparisonLevel;
    for (int count = 0; const Operator* found_operator = operator_at(level); ++count) {
      if (comparing && count > 0) fail("comparisons cannot be chained; write a < b && b < c");
      ++next_;
      binary(level + 1);
      writer_.add({.op = found_operator->op});
    }
  }

  void sign() {
    if (!at("-") && !at("+") && !at("!")) return power();
    const Nested nested(*this);
    const bool negate = at("-");
    const bool invert = at("!");
    ++next_;
    sign();
    if (negate) writer_.add({.op = Op::Negate});
    if (invert) writer_.add({.op = Op::Not});
  }

  void power() {
    atom();
    if (!accept("^")) return;
    const Nested nested(*this);
    sign();
    writer_.add_power();
  }

  void atom() {
    if (token().kind == TokenKind::Number) {
      writer_.add({.op = Op::Constant, .constant = token().number});
      ++next_;
    } else if (token().kind == TokenKind::Name) {
      name();
    } else if (accept("(")) {
      const Nested nested(*this);
      choice();
      expect(")", "to close '('");
    } else if (at_end()) {
      fail(next_ == 0 ? "the expression is empty" : "the expression ends where a value is expected");
    } else {
      fail("a value is expected, found " + found());
    }
  }

  void name() {
    const Token written = token();
    ++next_;
    const bool called = at("(");
    if (names_.is_function(written.text)) {
      if (!called) fail("the function " + std::string(written.text) + " needs its arguments in parentheses");
      return call(written);
    }
    const std::optional<Instruction> variable = names_.find_variable(written.text);
    if (!variable) throw ExpressionError(written.position, names_.unknown(written.text, called));
    if (called) throw ExpressionError(written.position, "'" + std::string(written.text) + "' is not a function");
    writer_.add(*variable);
  }

  void call(const Token& function) {
    const Nested nested(*this);
    expect("(", "after the function");
    const std::optional<UnaryFunction> unary = find_unary(function.text);
    const bool variadic = function.text == "min" || function.text == "max";
    int num_arguments = 0;
    if (at(")")) fail("the function " + std::string(function.text) + " needs an argument");
    do {
      choice();
      if (++num_arguments > 1 && !unary && (variadic || num_arguments == 2)) {
        writer_.add_call(*find_binary(function.text));
      }
    } while (accept(","));
    expect(")", "to close the arguments of " + std::string(function.text));
    check_arguments(function, unary ? 1 : 2, num_arguments, variadic);
    if (unary) writer_.add({.op = Op::Unary, .index = static_cast<std::int32_t>(*unary)});
  }

  static void check_arguments(const Token& function, int wanted, int given, bool variadic) {
    if (given == wanted || (variadic && given > wanted)) return;
    throw ExpressionError(function.position, "the function " + std::string(function.text) + " takes " +
                                                 std::to_string(wanted) + (variadic ? " or more" : "") +
                                                 (wanted == 1 ? " argument, " : " arguments, ") +
                                                 std::to_string(given) + " given");
  }

  std::vector<Token> tokens_;
  const ExpressionNames& names_;
  TapeWriter writer_;
  std::size_t next_ = 0;
  int depth_ = 0;
};

}  // namespace

Tape compile(std::string_view text, const std::map<std::string, double>& symbols,
             const std::vector<std::string>& extra_variables, const std::vector<std::string>& coordinates) {
  const ExpressionNames names(symbols, extra_variables, coordinates);
  return Parser(tokenize(text), names).parse();
}

}  // namespace parmesan
