/* Host lookup of a program that brings the C library along.
 *
 * glibc's getaddrinfo loads what the machine's nsswitch.conf names as shared libraries, which belong to the machine's own C library; beside another
 * version of it in the same process they can crash. A static program therefore looks up hosts in /etc/hosts and by DNS alone, which are inside. */
#include <nss.h>
#include <sys/auxv.h>

/* 1 in a static program, which the kernel started without a dynamic linker beside it; its lookups are limited from then on. */
int ros_looks_up_alone(void) {
  if (getauxval(AT_BASE) != 0) return 0;
#ifdef __GLIBC__
  __nss_configure_lookup("hosts", "files dns");
#endif
  return 1;
}
