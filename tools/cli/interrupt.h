#pragma once

#include <atomic>

namespace parmesan {

/// From now on the first SIGINT, SIGTERM or SIGHUP sets the flag that is returned; a second one of its kind ends
/// the process at once. One that is ignored already, as by nohup, stays ignored. The flag lives as long as the process.
const std::atomic<bool>& watch_for_interrupt();

/// 128 + the number of the signal that came, 0 when none did.
int interrupt_exit_code();

}  // namespace parmesan
