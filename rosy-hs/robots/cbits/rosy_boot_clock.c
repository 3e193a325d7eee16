/* Seconds since this computer was started, counted also while it sleeps and while this process is suspended. */
#define _GNU_SOURCE
#include <time.h>

double rosy_boot_seconds(void) {
  struct timespec t;
  clock_gettime(CLOCK_BOOTTIME, &t);
  return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}
