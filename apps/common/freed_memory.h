#pragma once

namespace meshalyzer {

/// Makes the allocator return every block of 4 MiB and more to the system as soon as it is freed.
///
/// By default glibc keeps blocks of up to 32 MiB for later requests once one was freed, where they
/// lie between others: a tenth of the memory of a large mesh.
void return_large_blocks();

}  // namespace meshalyzer
