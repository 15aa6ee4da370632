#pragma once

namespace meshalyzer {

/// Makes the allocator return every large block to the system as soon as it is freed.
///
/// By default glibc keeps blocks of up to 32 MiB for later requests once one was freed, where they
/// lie between others: a fifth of the memory of a large mesh.
void return_large_blocks();

}  // namespace meshalyzer
