#pragma once

#include <cstddef>

namespace meshalyzer {

/// Makes the allocator return every large block to the system as soon as it is freed.
///
/// By default glibc keeps blocks of up to 32 MiB for later requests once one was freed, where they
/// lie between others: a tenth of the memory of a large mesh. Of what is free at the end of the
/// heap it keeps only 128 KiB by default; here it keeps 24 MiB. The system fills memory with zeros
/// when it gives it again, which takes time where it is often returned.
///
/// @param least_mib  The size from which on a block is returned, in MiB.
void return_large_blocks(int least_mib);

/// Makes the allocator keep all freed memory if the files that a program works on are small, and
/// return large blocks if they are not. The rounds of a repair allocate and free the same arrays
/// again and again: keeping them saves a fifth of the time, and takes up to two fifths more memory.
///
/// @param n_bytes  The size of the files, unpacked.
void keep_freed_memory_if_small(std::size_t n_bytes);

}  // namespace meshalyzer
