// Memory that was freed -> the system's again.
#pragma once

namespace spoctree {

/// The C library keeps what is freed, in case it is wanted again. Between two steps that take most
/// of the memory and have little in common, this gives it back, where that is possible. Some
/// milliseconds per gigabyte.
void give_back_memory();

}  // namespace spoctree
