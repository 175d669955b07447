#pragma once

#include <cstddef>
#include <utility>

#include "adapt/expression_functions.h"
#include "adapt/expression_tape.h"

namespace parmesan {

/// Writes a tape instruction by instruction, computes constant parts on the way, and keeps count
/// of the stack.
class TapeWriter {
 public:
  explicit TapeWriter(std::size_t num_extra) { tape_.uses_extra.assign(num_extra, false); }

  /// Errors: ExpressionError when the stack would grow beyond kMaxExpressionStack.
  void add(const Instruction& instruction);
  void add_call(BinaryFunction function);

  /// The two on top become base ^ exponent; a constant exponent goes into the instruction.
  void add_power();

  /// Adds a jump whose goal land() sets later; returns its place.
  std::size_t jump(Op op);

  /// The jump goes to the next instruction that is added. Nothing is folded across it.
  void land(std::size_t jump);

  Tape finish() && { return std::move(tape_); }

 private:
  bool constants_on_top(std::size_t count) const;
  void push();
  void fold_last(std::size_t count);  // count instructions become the constant they compute

  Tape tape_;
  std::size_t stack_ = 0;      // values on the stack here
  std::size_t fold_from_ = 0;  // code before may be jumped over
};

}  // namespace parmesan
