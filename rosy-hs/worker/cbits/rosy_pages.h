/* Pages of memory, which are larger than the run-time system's blocks on some machines. */
#ifndef ROSY_PAGES_H
#define ROSY_PAGES_H

#include <stdint.h>

/*
 * Narrows the range from *begin to before *end to the pages of `page` bytes (a power of two) that lie in it wholly; 0 when there is none.
 *
 * Blocks have 4 kB, pages have 16 kB on a Raspberry Pi 5 and 64 kB on some servers. madvise(2) refuses a range that begins within a page, and of
 * one that ends within a page it clears the whole page, with the blocks in use behind it.
 */
int rosy_whole_pages(uintptr_t *begin, uintptr_t *end, uintptr_t page);

#endif
