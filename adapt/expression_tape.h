#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace parmesan {

/// What an instruction does with the top of the stack. Comparisons and logic give 0 or 1.
enum class Op : std::uint8_t {
  Constant,  // push constant
  X,         // push x
  Y,         // push y
  Extra,     // push extra variable number index
  Add,       // the two on top become one
  Subtract,
  Multiply,
  Divide,
  Less,
  LessEqual,
  Greater,
  GreaterEqual,
  Equal,
  NotEqual,
  And,
  Or,
  Binary,  // function number index of the two on top
  Negate,  // the one on top is replaced
  Not,
  Power,       // raised to constant
  Unary,       // function number index
  JumpIfZero,  // pop; go to instruction number index if it was 0
  Jump         // go to instruction number index
};

struct Instruction {
  Op op = Op::Constant;
  std::int32_t index = 0;
  double constant = 0.0;
};

/// An expression in postfix order for a stack machine. Only ?: jumps, and only forwards.
struct Tape {
  std::vector<Instruction> code;
  std::size_t stack_size = 0;    // largest number of values on the stack
  std::vector<bool> uses_extra;  // per extra variable
  bool uses_point = false;       // x or y occurs
};

/// The deepest nesting, the longest text in tokens and the largest stack an expression may need.
inline constexpr int kMaxExpressionDepth = 200;
inline constexpr std::size_t kMaxExpressionTokens = 10'000;
inline constexpr std::size_t kMaxExpressionStack = 512;

/// Compiles an expression; constant parts are computed once, here.
///
/// Grammar, loosest binding first:
///     choice: or ['?' choice ':' choice]     or: ||   and: &&   equality: == !=
///     comparison: < <= > >=                  sum: + -           product: * /
///     sign: (+ - !) sign | power             power: atom ['^' sign]
///     atom: number | name | name '(' choice {',' choice} ')' | '(' choice ')'
/// Errors: ExpressionError. Cost: O(length).
Tape compile(std::string_view text, const std::map<std::string, double>& symbols,
             const std::vector<std::string>& extra_variables, const std::vector<std::string>& coordinates);

}  // namespace parmesan
