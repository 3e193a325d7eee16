#include "rosy_pages.h"

int rosy_whole_pages(uintptr_t *begin, uintptr_t *end, uintptr_t page) {
  *begin = (*begin + page - 1) & ~(page - 1);
  *end &= ~(page - 1);
  return *begin < *end;
}
