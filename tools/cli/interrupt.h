#pragma once

#include <atomic>

namespace parmesan {

/// From now on the first SIGINT or SIGTERM sets the flag that is returned; a second one ends the
/// process at once. The flag lives as long as the process.
const std::atomic<bool>& watch_for_interrupt();

/// 128 + the number of the signal that came, 0 when none did.
int interrupt_exit_code();

}  // namespace parmesan
