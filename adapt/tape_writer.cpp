#include "adapt/tape_writer.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>

#include "adapt/expression.h"
#include "adapt/expression_evaluate.h"
#include "mesher/index.h"

namespace parmesan {
namespace {

std::size_t num_operands(Op op) {
  if (op <= Op::Extra) return 0;
  return op <= Op::Binary ? 2 : 1;
}

}  // namespace

void TapeWriter::push() {
  if (++stack_ > kMaxExpressionStack) {
    throw ExpressionError(0, "the expression is nested too deep: it holds more than " +
                                 std::to_string(kMaxExpressionStack) + " unfinished operations");
  }
  tape_.stack_size = std::max(tape_.stack_size, stack_);
}

bool TapeWriter::constants_on_top(std::size_t count) const {
  if (tape_.code.size() < fold_from_ + count) return false;
  return std::all_of(tape_.code.end() - static_cast<std::ptrdiff_t>(count), tape_.code.end(),
                     [](const Instruction& i) { return i.op == Op::Constant; });
}

void TapeWriter::add(const Instruction& instruction) {
  if (instruction.op == Op::X || instruction.op == Op::Y) tape_.uses_point = true;
  if (instruction.op == Op::Extra) tape_.uses_extra[at(instruction.index)] = true;
  const std::size_t count = num_operands(instruction.op);
  if (count == 0) push();
  if (count == 2) --stack_;
  const bool fold = count > 0 && constants_on_top(count);
  tape_.code.push_back(instruction);
  if (fold) fold_last(count + 1);
}

void TapeWriter::fold_last(std::size_t count) {
  std::array<double, 2> stack{};
  const double result = evaluate<double>(std::span(tape_.code).last(count), stack.data(), 0.0, 0.0, {});
  tape_.code.resize(tape_.code.size() - count);
  tape_.code.push_back({.op = Op::Constant, .constant = result});
}

void TapeWriter::add_call(BinaryFunction function) {
  if (function == BinaryFunction::Pow) return add_power();
  add({.op = Op::Binary, .index = static_cast<std::int32_t>(function)});
}

void TapeWriter::add_power() {
  if (!constants_on_top(1)) {
    return add({.op = Op::Binary, .index = static_cast<std::int32_t>(BinaryFunction::Pow)});
  }
  const double exponent = tape_.code.back().constant;
  tape_.code.pop_back();
  --stack_;
  add({.op = Op::Power, .constant = exponent});
}

std::size_t TapeWriter::jump(Op op) {
  --stack_;  // the condition, or the first choice's value, of which only one is ever on the stack
  tape_.code.push_back({.op = op});
  return tape_.code.size() - 1;
}

void TapeWriter::land(std::size_t jump) {
  tape_.code[jump].index = static_cast<std::int32_t>(tape_.code.size());
  fold_from_ = tape_.code.size();
}

}  // namespace parmesan
