#pragma once

namespace meshalyzer {

/// Makes the allocator return every large block to the system as soon as it is freed.
///
/// By default glibc keeps blocks of up to 32 MiB for later requests once one was freed, where they
/// lie between others: a tenth of the memory of a large mesh.
///
/// @param least_mib  The size from which on a block is returned, in MiB. The system fills each
///                   block with zeros when it gives it again, which takes time where blocks are
///                   often freed and allocated.
void return_large_blocks(int least_mib);

}  // namespace meshalyzer
