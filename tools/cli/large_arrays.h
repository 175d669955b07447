#pragma once

/// Gives arrays of 4 MB and more back to the system as soon as they are freed, and keeps what smaller ones leave. To be
/// called before there are any.
void give_back_large_arrays();
