/*
 * System calls of the worker that Haskell's libraries do not offer: descriptors that ride on a socket, one poll
 * over everything, pages shared with children, and what a child gives up before it touches a stranger's program.
 *
 * Nothing here knows the protocol or the compiler. Each layer (filter, limits, descriptors) works without the others.
 */
#define _GNU_SOURCE
#include "rosy_sys.h"
#include "rosy_pages.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/capability.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <linux/securebits.h>
#include <poll.h>
#include <signal.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "Rts.h"

/* ---- Receiving and sending ---------------------------------------------------------------------------------- */

/* Reads what is there; up to two descriptors that rode along end in received_fds (else -1). Further ones are closed. */
ssize_t rosy_receive(int fd, void *buffer, size_t size, int received_fds[2]) {
  struct iovec part = {buffer, size};
  union { char space[CMSG_SPACE(8 * sizeof(int))]; struct cmsghdr align; } control;
  struct msghdr message = {.msg_iov = &part, .msg_iovlen = 1, .msg_control = &control, .msg_controllen = sizeof control};
  ssize_t got;
  size_t kept = 0;
  received_fds[0] = received_fds[1] = -1;
  do got = recvmsg(fd, &message, MSG_CMSG_CLOEXEC | MSG_DONTWAIT); while (got < 0 && errno == EINTR);
  if (got < 0) return errno == EAGAIN || errno == EWOULDBLOCK ? -2 : -1;
  for (struct cmsghdr *c = CMSG_FIRSTHDR(&message); c; c = CMSG_NXTHDR(&message, c)) {
    if (c->cmsg_level != SOL_SOCKET || c->cmsg_type != SCM_RIGHTS) continue;
    size_t count = (c->cmsg_len - CMSG_LEN(0)) / sizeof(int);
    for (size_t i = 0; i < count; i++) {
      int one;
      memcpy(&one, CMSG_DATA(c) + i * sizeof(int), sizeof one);
      if (kept < 2) received_fds[kept++] = one; else close(one);
    }
  }
  return got;
}

/* Writes what fits; -2 when nothing does for now, -1 when the other end is gone. */
ssize_t rosy_send(int fd, const void *buffer, size_t size) {
  ssize_t put;
  do put = send(fd, buffer, size, MSG_DONTWAIT | MSG_NOSIGNAL); while (put < 0 && errno == EINTR);
  if (put < 0) return errno == EAGAIN || errno == EWOULDBLOCK ? -2 : -1;
  return put;
}

/* Sends bytes with one or two descriptors; -1 when not all of them fit for now, or the other end is gone: then it must be given up. */
int rosy_send_link(int fd, const void *buffer, size_t size, int count, const int *passed) {
  struct iovec part = {(void *)buffer, size};
  union { char space[CMSG_SPACE(2 * sizeof(int))]; struct cmsghdr align; } control = {{0}};
  struct msghdr message = {.msg_iov = &part, .msg_iovlen = 1, .msg_control = &control, .msg_controllen = CMSG_SPACE(count * sizeof(int))};
  struct cmsghdr *header = CMSG_FIRSTHDR(&message);
  ssize_t put;
  header->cmsg_level = SOL_SOCKET;
  header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(count * sizeof(int));
  memcpy(CMSG_DATA(header), passed, count * sizeof(int));
  do put = sendmsg(fd, &message, MSG_DONTWAIT | MSG_NOSIGNAL); while (put < 0 && errno == EINTR);
  return put == (ssize_t)size ? 0 : -1;
}

/* ---- Waiting ------------------------------------------------------------------------------------------------ */

static int child_pipe[2] = {-1, -1};

static void child_ended(int signal) {
  int saved = errno;
  (void)signal;
  if (write(child_pipe[1], "", 1) < 0) { /* full: the reader is awake already */ }
  errno = saved;
}

/* From now on a byte arrives at the returned descriptor whenever a child has ended. */
int rosy_watch_children(void) {
  struct sigaction action = {.sa_handler = child_ended, .sa_flags = SA_RESTART | SA_NOCLDSTOP};
  if (pipe2(child_pipe, O_CLOEXEC | O_NONBLOCK) < 0) return -1;
  if (sigaction(SIGCHLD, &action, NULL) < 0) return -1;
  signal(SIGPIPE, SIG_IGN);
  return child_pipe[0];
}

void rosy_drain(int fd) {
  char waste[256];
  while (read(fd, waste, sizeof waste) > 0) {}
}

/* poll(2) over parallel arrays. The RTS's timer signal may interrupt it: that counts as nothing yet. */
int rosy_poll(int count, const int *fds, const short *wants, short *got, int milliseconds) {
  struct pollfd *set = calloc(count > 0 ? count : 1, sizeof *set);
  if (!set) return -1;
  for (int i = 0; i < count; i++) { set[i].fd = fds[i]; set[i].events = wants[i]; }
  int ready = poll(set, count, milliseconds);
  for (int i = 0; i < count; i++) got[i] = ready > 0 ? set[i].revents : 0;
  free(set);
  return ready < 0 && errno == EINTR ? 0 : ready;
}

/* One ended child: its pid, and *how 0 = exit code, 1 = signal in *value. 0 when none has ended. */
pid_t rosy_reap(int *how, int *value) {
  int status;
  pid_t pid = waitpid(-1, &status, WNOHANG);
  if (pid <= 0) return 0;
  *how = WIFSIGNALED(status);
  *value = *how ? WTERMSIG(status) : WEXITSTATUS(status);
  return pid;
}

/* ---- Sharing ------------------------------------------------------------------------------------------------ */

/* A page of zeros that a forked child and its parent both see. */
/* Later children do not inherit it: see rosy_page_keep. */
void *rosy_page(void) {
  void *page = mmap(NULL, 4096, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  return page == MAP_FAILED ? NULL : page;
}

void rosy_page_free(void *page) { munmap(page, 4096); }

/* To be called in the parent after the fork: children forked from now on do not see this page. */
void rosy_page_keep(void *page) { madvise(page, 4096, MADV_DONTFORK); }

int rosy_pair(int *ends) { return socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends); }

/* All of it, waiting as long as it takes. */
int rosy_write_all(int fd, const char *buffer, size_t size) {
  while (size > 0) {
    ssize_t put = write(fd, buffer, size);
    if (put < 0 && errno == EINTR) continue;
    if (put <= 0) return -1;
    buffer += put;
    size -= (size_t)put;
  }
  return 0;
}

/* ---- Becoming a child --------------------------------------------------------------------------------------- */

static int is_kept(int fd, int count, const int *keep) {
  for (int i = 0; i < count; i++) if (keep[i] == fd) return 1;
  return 0;
}

/* When the machine runs out of memory, the kernel ends this process before those of others. proc(5), oom_score_adj. */
static void volunteer_for_oom(void) {
  int fd = open("/proc/self/oom_score_adj", O_WRONLY | O_CLOEXEC);
  if (fd < 0) return;
  if (write(fd, "1000", 4) < 0) { /* the limits of memory hold without it */ }
  close(fd);
}

/*
 * Drops every capability of this process, for good: the effective, permitted, inheritable, ambient and, where it may, the bounding set.
 * A process of the administrator without capabilities is bound by file permissions and may not mount, trace or signal others' processes.
 * capabilities(7). Returns -1 when one of the first three sets could not be cleared.
 */
int rosy_drop_capabilities(void) {
  struct __user_cap_header_struct header = {_LINUX_CAPABILITY_VERSION_3, 0};
  struct __user_cap_data_struct none[_LINUX_CAPABILITY_U32S_3] = {{0, 0, 0}, {0, 0, 0}};
  /* These two need CAP_SETPCAP; who lacks it has no capability to lose by a later exec, which no_new_privs forbids besides. */
  prctl(PR_SET_SECUREBITS, SECBIT_NOROOT | SECBIT_NOROOT_LOCKED | SECBIT_NO_SETUID_FIXUP | SECBIT_NO_SETUID_FIXUP_LOCKED, 0, 0, 0);
  for (int capability = 0; prctl(PR_CAPBSET_READ, capability, 0, 0, 0) >= 0; capability++) prctl(PR_CAPBSET_DROP, capability, 0, 0, 0);
  prctl(PR_CAP_AMBIENT, PR_CAP_AMBIENT_CLEAR_ALL, 0, 0, 0);
  return (int)syscall(SYS_capset, &header, none);
}

/* Fails where the parent has died already. */
static int die_with_parent(void) {
  pid_t parent = getppid();
  if (prctl(PR_SET_PDEATHSIG, SIGKILL) < 0) return -1;
  return getppid() != parent || parent == 1 ? -1 : 0;
}

/* Closes all descriptors from 3 on that are not kept. */
static void close_others(int count, const int *keep) {
  int last = 2;
  for (int i = 0; i < count; i++) if (keep[i] > last) last = keep[i];
  for (int fd = 3; fd < last; fd++) if (!is_kept(fd, count, keep)) close(fd);
#ifdef SYS_close_range
  if (syscall(SYS_close_range, last + 1, ~0U, 0) < 0)
#endif
    for (int fd = last + 1; fd < 65536; fd++) close(fd);
}

/* A forked worker dies with its parent, and has nothing of its parent open but the kept descriptors and 0 to 2. */
int rosy_fork_begin(int count, const int *keep) {
  if (die_with_parent() < 0) return -1;
  close_others(count, keep);
  return 0;
}

/*
 * Dies with its parent, leads its own session, knows no environment, has nothing open but the kept descriptors and an empty 0, 1 and 2,
 * starts no core dump, holds no capability, and, unless a test wants to see what the other layers do, can gain no privilege and write no file.
 */
int rosy_child_begin(int count, const int *keep, int null_fd, int no_files, int no_privileges) {
  struct rlimit none = {0, 0};
  if (die_with_parent() < 0) return -1;
  volunteer_for_oom();
  signal(SIGCHLD, SIG_DFL);
  clearenv();
  setsid();
  for (int fd = 0; fd < 3; fd++) if (dup2(null_fd, fd) < 0) return -1;
  close_others(count, keep);
  setrlimit(RLIMIT_CORE, &none);
  if (no_files) setrlimit(RLIMIT_FSIZE, &none);
  if (no_privileges && prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) < 0) return -1;
  if (rosy_drop_capabilities() < 0) return -1;
  prctl(PR_SET_DUMPABLE, 0, 0, 0, 0);
  return 0;
}

/*
 * Makes every mapping that is both writable and executable not executable; there is one, the stack, because Debian's libHSrts asks for an
 * executable one. The interpreter's own code lies in mappings that cannot be written. Returns -1 when a mapping stays both.
 */
int rosy_protect_memory(void) {
  /* The stack may grow between the look and the change, hence a second look. */
  for (int look = 0; look < 3; look++) {
    FILE *maps = fopen("/proc/self/maps", "re");
    unsigned long start, end;
    char line[512], access[5];
    int found = 0;
    if (!maps) return -1;
    while (fgets(line, sizeof line, maps))
      if (sscanf(line, "%lx-%lx %4s", &start, &end, access) == 3 && access[1] == 'w' && access[2] == 'x') {
        found = 1;
        mprotect((void *)start, end - start, PROT_READ | PROT_WRITE);
      }
    fclose(maps);
    if (!found) return 0;
  }
  errno = EACCES;
  return -1;
}

/*
 * Maps the code of all libraries that is in memory. A fork does not copy these mappings, and a compilation would add them one by one: a
 * third of the time of a small one. madvise(2), MADV_POPULATE_READ; a system without it maps them as before. It stops when there is something to
 * read.
 */
void rosy_map_code(int fd) {
#ifdef MADV_POPULATE_READ
  FILE *maps = fopen("/proc/self/maps", "re");
  unsigned long start, end, inode;
  char line[512], access[5];
  if (!maps) return;
  while (fgets(line, sizeof line, maps))
    if (sscanf(line, "%lx-%lx %4s %*s %*s %lu", &start, &end, access, &inode) == 4 && inode != 0 && access[2] == 'x') {
      struct pollfd order = {.fd = fd, .events = POLLIN};
      if (poll(&order, 1, 0) != 0) break;
      madvise((void *)start, end - start, MADV_POPULATE_READ);
    }
  fclose(maps);
#else
  (void)fd;
#endif
}

/* As the system shows this process. */
int rosy_name(const char *name) { return prctl(PR_SET_NAME, name, 0, 0, 0); }

/* Lower priority than processes that are not nice, and than the starter of this one, however nice that is. */
int rosy_nice(int niceness) {
  int nicer = getpriority(PRIO_PROCESS, 0) + niceness;
  return setpriority(PRIO_PROCESS, 0, nicer > niceness ? nicer : niceness);
}

/* Bytes of writable private memory now (VmData), the baseline that limits are counted from. */
uint64_t rosy_data_size(void) {
  uint64_t kilobytes = 0;
  char line[256];
  FILE *status = fopen("/proc/self/status", "re");
  if (!status) return 0;
  while (fgets(line, sizeof line, status))
    if (sscanf(line, "VmData: %lu kB", &kilobytes) == 1) break;
  fclose(status);
  return kilobytes * 1024;
}

/* Seconds of processor time that a process has used; -1 when it has ended. clock_getcpuclockid(3). */
double rosy_processor_time(int pid) {
  clockid_t clock;
  struct timespec used;
  if (clock_getcpuclockid(pid, &clock) || clock_gettime(clock, &used)) return -1;
  return used.tv_sec + used.tv_nsec / 1e9;
}

/* Bytes of memory of a process that no file backs, pages shared since a fork included; 0 when it has ended. proc(5), statm. */
uint64_t rosy_anonymous_memory(int pid) {
  char path[32];
  unsigned long total, resident, shared;
  snprintf(path, sizeof path, "/proc/%d/statm", pid);
  FILE *statm = fopen(path, "re");
  if (!statm) return 0;
  int read = fscanf(statm, "%lu %lu %lu", &total, &resident, &shared);
  fclose(statm);
  return read == 3 && resident > shared ? (resident - shared) * (uint64_t)sysconf(_SC_PAGESIZE) : 0;
}

/* Bytes of memory that the machine has. */
uint64_t rosy_machine_memory(void) { return (uint64_t)sysconf(_SC_PHYS_PAGES) * (uint64_t)sysconf(_SC_PAGESIZE); }

/* The kernel refuses more private memory than this; may be raised again. */
int rosy_limit_data(uint64_t bytes) {
  struct rlimit data;
  if (getrlimit(RLIMIT_DATA, &data) < 0) return -1;
  if (bytes < data.rlim_max) data.rlim_cur = bytes;
  return setrlimit(RLIMIT_DATA, &data);
}

/* The kernel ends this process when it has computed for so many seconds more. */
int rosy_limit_cpu(uint64_t seconds) {
  struct rusage used;
  if (getrusage(RUSAGE_SELF, &used) < 0) return -1;
  struct rlimit cpu = {used.ru_utime.tv_sec + used.ru_stime.tv_sec + 1 + seconds, RLIM_INFINITY};
  struct rlimit now;
  if (getrlimit(RLIMIT_CPU, &now) < 0) return -1;
  cpu.rlim_max = now.rlim_max;
  return setrlimit(RLIMIT_CPU, &cpu);
}

/* The kernel refuses more private memory than this (0: any), and, when it is to be alone, further processes and threads. */
int rosy_limit_process(uint64_t data_bytes, int alone) {
  struct rlimit data = {data_bytes, data_bytes}, none = {0, 0};
  if (data_bytes && setrlimit(RLIMIT_DATA, &data) < 0) return -1;
  if (alone) setrlimit(RLIMIT_NPROC, &none);
  setrlimit(RLIMIT_MSGQUEUE, &none);
  setrlimit(RLIMIT_MEMLOCK, &none);
  return 0;
}

/* The run-time system raises HeapOverflow when its heap has grown by more than this. */
void rosy_limit_heap(uint64_t bytes) {
  RtsFlags.GcFlags.maxHeapSize = (mblocks_allocated * MBLOCK_SIZE + bytes) / BLOCK_SIZE;
}

/* How much a program may allocate between two collections; the next collection makes it so. */
void rosy_area(uint64_t bytes) { RtsFlags.GcFlags.minAllocAreaSize = bytes / BLOCK_SIZE; }

/* The area before rosy_defer_collections; 0 when none are deferred. */
static uint32_t usual_area;

/*
 * Until the next compaction the area is so large, and there is no collection of the oldest generation before that has so many bytes. Almost all that
 * is allocated while a session is opened stays: of 2.0 s that this took, 1.3 s were collections. With 32 and 70 MB it takes 1.5 s. With 64 and
 * 256 MB it takes 1.3 s, but what is free at the end lies among what is used, and the process keeps 21 MB more.
 */
void rosy_defer_collections(uint64_t area, uint64_t oldest) {
  usual_area = RtsFlags.GcFlags.minAllocAreaSize;
  rosy_area(area);
  oldest_gen->max_blocks = oldest / BLOCK_SIZE;
}

/*
 * Makes the next major collection give all free memory back to the system at once. The run-time system would keep several times of what
 * is in use, also what that collection has just copied.
 */
static double usual_factor;
void rosy_compact_begin(void) {
  if (usual_area) RtsFlags.GcFlags.minAllocAreaSize = usual_area;
  usual_area = 0;
  usual_factor = RtsFlags.GcFlags.oldGenFactor;
  RtsFlags.GcFlags.oldGenFactor = -1;
  RtsFlags.MiscFlags.disableDelayedOsMemoryReturn = true;
}

/* After that collection: the next one of the oldest generation comes when it has grown as usual, not at once. */
void rosy_compact_end(void) {
  W_ grown = (W_)(oldest_gen->n_blocks * usual_factor);
  RtsFlags.GcFlags.oldGenFactor = usual_factor;
  if (oldest_gen->max_blocks < grown) oldest_gen->max_blocks = grown;
  rosy_area_clear();
}

/* Gives back the pages that lie wholly between two addresses. */
static void clear_pages(char *begin, char *end) {
  uintptr_t first = (uintptr_t)begin, behind = (uintptr_t)end;
  if (rosy_whole_pages(&first, &behind, (uintptr_t)sysconf(_SC_PAGESIZE))) madvise((void *)first, behind - first, MADV_DONTNEED);
}

/*
 * Gives back the pages of the allocation area in which nothing stands. A child that is forked later gets pages of zeros there when it
 * needs them, which is quicker than copies of what is not read any more.
 */
void rosy_area_clear(void) {
  CapabilityPublic *mine = (CapabilityPublic *)rts_unsafeGetMyCapability();
  bdescr *block = mine->r.rCurrentNursery ? mine->r.rCurrentNursery->link : NULL;
  while (block) {
    char *begin = (char *)block->start, *end = begin;
    for (; block && (char *)block->start == end; block = block->link) end += BLOCK_SIZE;
    clear_pages(begin, end);
  }
}

/*
 * Whether what survives a collection stays among the young, where the next collection finds it again. Among the old, which lie beside what is
 * shared with the parent, it would stay also when it is not needed any more: collecting there copies the whole compiler.
 */
void rosy_stay_young(int stay) { generations[0].to = stay ? &generations[0] : &generations[1]; }

/*
 * All free blocks, which the run-time system keeps for later. They are found by taking them until there is none left: the run-time system then
 * gets a new megablock. Large groups first, so that there are few calls.
 */
static bdescr *take_free(bool clear) {
  bdescr *taken = NULL;
  for (W_ size = BLOCKS_PER_MBLOCK / 2; size > 0; size /= 2)
    for (bool is_new = false; !is_new;) {
      W_ before = mblocks_allocated;
      bdescr *group = allocGroup_lock(size);
      is_new = mblocks_allocated != before;
      if (clear && !is_new) clear_pages((char *)group->start, (char *)group->start + group->blocks * BLOCK_SIZE);
      group->link = taken;
      taken = group;
    }
  return taken;
}

static void give_back(bdescr *taken) {
  while (taken) {
    bdescr *next = taken->link;
    freeGroup_lock(taken);
    taken = next;
  }
}

/* Gives back the pages of all free blocks. */
void rosy_free_clear(void) { give_back(take_free(true)); }

/*
 * Between these two calls a collection takes a new allocation area from fresh memory, for which the kernel is asked for pages of 2 MB. Each first
 * use of a page of 4 kB costs a child 4 us here, a third of what compiling 30 lines took; free blocks among those that are shared with the
 * parent could have no large pages. The kernel gets a large page back when it needs memory, also if a few bytes of it are still in use.
 */
static bdescr *taken_free;
void rosy_fresh_begin(uint64_t area) {
  taken_free = take_free(false);
  /* What the collection itself needs comes from there as well. */
  W_ megablocks = area / MBLOCK_SIZE + 4;
  bdescr *fresh = allocGroup_lock(BLOCKS_PER_MBLOCK + (megablocks - 1) * (MBLOCK_SIZE / BLOCK_SIZE));
  madvise((void *)((W_)fresh->start & ~MBLOCK_MASK), megablocks * MBLOCK_SIZE, MADV_HUGEPAGE);
  freeGroup_lock(fresh);
}

void rosy_fresh_end(void) {
  give_back(taken_free);
  taken_free = NULL;
}

void rosy_exit(int code) { _exit(code); }

/* ---- Filters ------------------------------------------------------------------------------------------------ */

#if defined(__x86_64__)
#define ROSY_ARCH AUDIT_ARCH_X86_64
#elif defined(__aarch64__)
#define ROSY_ARCH AUDIT_ARCH_AARCH64
#else
#error "the filter knows x86-64 and aarch64"
#endif

#define LOAD(field) BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, field))
#define ARGUMENT(n) (offsetof(struct seccomp_data, args) + 8 * (n))
#define ALLOW BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW)
#define REFUSE BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EPERM)
#define MISSING BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | ENOSYS)

/* What a running program needs: its link, memory, time, its own signals, its end. */
static const int running_calls[] = {
  __NR_read, __NR_write, __NR_readv, __NR_writev, __NR_close, __NR_lseek, __NR_fstat,
  __NR_munmap, __NR_madvise, __NR_brk, __NR_mremap,
  __NR_rt_sigaction, __NR_rt_sigprocmask, __NR_rt_sigreturn, __NR_sigaltstack, __NR_restart_syscall,
  __NR_futex, __NR_sched_yield, __NR_getpid, __NR_gettid, __NR_getrusage,
  __NR_clock_gettime, __NR_clock_getres, __NR_gettimeofday, __NR_nanosleep, __NR_clock_nanosleep,
  __NR_timer_settime, __NR_timer_delete, __NR_timerfd_settime, __NR_getitimer, __NR_setitimer,
  __NR_pselect6, __NR_ppoll, __NR_exit, __NR_exit_group, __NR_getrandom,
#ifdef __NR_poll
  __NR_poll, __NR_select, __NR_time,
#endif
};

/* What the compiler needs besides: looking at the interfaces and libraries that are there. */
static const int compiling_calls[] = {
  __NR_pread64, __NR_newfstatat, __NR_statx, __NR_statfs, __NR_faccessat, __NR_readlinkat, __NR_getcwd, __NR_getdents64, __NR_uname,
  __NR_getpriority, __NR_setpriority, __NR_dup, __NR_dup3, __NR_prctl, __NR_seccomp, __NR_setrlimit, __NR_getrlimit, __NR_sysinfo, __NR_flock,
  __NR_epoll_ctl, __NR_epoll_pwait, __NR_timer_create, __NR_getuid, __NR_geteuid, __NR_getgid, __NR_getegid, __NR_getppid,
#ifdef __NR_stat
  __NR_stat, __NR_lstat, __NR_access, __NR_readlink, __NR_dup2, __NR_epoll_wait,
#endif
};

#define COUNT(a) (sizeof(a) / sizeof((a)[0]))
#define MOST 256

static struct sock_filter code[MOST];
static int length;

static void put(struct sock_filter one) { if (length < MOST) code[length++] = one; }

static void allow_each(const int *calls, size_t count) {
  for (size_t i = 0; i < count; i++) {
    put((struct sock_filter)BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, calls[i], 0, 1));
    put((struct sock_filter)ALLOW);
  }
}

/* Allows a call when the bits of `mask` in argument n are all clear; the number is loaded again afterwards. */
static void allow_without_bits(int call, int n, unsigned mask) {
  put((struct sock_filter)BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, call, 0, 4));
  put((struct sock_filter)BPF_STMT(BPF_LD | BPF_W | BPF_ABS, ARGUMENT(n)));
  put((struct sock_filter)BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, mask, 1, 0));
  put((struct sock_filter)ALLOW);
  put((struct sock_filter)REFUSE);
}

/* Allows a call when argument n is exactly `value`. */
static void allow_with_value(int call, int n, unsigned value) {
  put((struct sock_filter)BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, call, 0, 4));
  put((struct sock_filter)BPF_STMT(BPF_LD | BPF_W | BPF_ABS, ARGUMENT(n)));
  put((struct sock_filter)BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 0, 1));
  put((struct sock_filter)ALLOW);
  put((struct sock_filter)REFUSE);
}

static void begin_filter(void) {
  length = 0;
  put((struct sock_filter)LOAD(arch));
  put((struct sock_filter)BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, ROSY_ARCH, 1, 0));
  put((struct sock_filter)BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS));
  put((struct sock_filter)LOAD(nr));
#if defined(__x86_64__)
  /* The x32 calls share the numbers but not the meaning. */
  put((struct sock_filter)BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, 0x40000000U, 0, 1));
  put((struct sock_filter)REFUSE);
#endif
  allow_each(running_calls, COUNT(running_calls));
  /* Its own threads may be signalled (abort, RTS), no others. */
  allow_with_value(__NR_tgkill, 0, (unsigned)getpid());
  /* fcntl: only F_GETFD, F_SETFD, F_GETFL and F_SETFL (1 to 4). */
  put((struct sock_filter)BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_fcntl, 0, 5));
  put((struct sock_filter)BPF_STMT(BPF_LD | BPF_W | BPF_ABS, ARGUMENT(1)));
  put((struct sock_filter)BPF_JUMP(BPF_JMP | BPF_JGT | BPF_K, 4, 2, 0));
  put((struct sock_filter)BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, 0, 1, 0));
  put((struct sock_filter)ALLOW);
  put((struct sock_filter)REFUSE);
}

static int end_filter(void) {
  put((struct sock_filter)REFUSE);
  if (length >= MOST) { errno = E2BIG; return -1; }
  struct sock_fprog program = {(unsigned short)length, code};
  return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program, 0, 0);
}

/* While compiling: files may be opened for reading; no sockets, no processes, no signals to others. */
int rosy_filter_compiling(void) {
  begin_filter();
  allow_each(compiling_calls, COUNT(compiling_calls));
  allow_without_bits(__NR_openat, 2, O_WRONLY | O_RDWR | O_CREAT | O_TRUNC);
#ifdef __NR_open
  allow_without_bits(__NR_open, 1, O_WRONLY | O_RDWR | O_CREAT | O_TRUNC);
#endif
  /* The interpreter makes code for each data constructor of a program. */
  static const int memory_calls[] = {__NR_mmap, __NR_mprotect};
  allow_each(memory_calls, COUNT(memory_calls));
  put((struct sock_filter)BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_prlimit64, 0, 4));
  put((struct sock_filter)BPF_STMT(BPF_LD | BPF_W | BPF_ABS, ARGUMENT(0)));
  put((struct sock_filter)BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, 0, 0, 1));
  put((struct sock_filter)ALLOW);
  put((struct sock_filter)REFUSE);
  return end_filter();
}

/* While running: nothing is opened, and no memory becomes code. */
int rosy_filter_running(void) {
  begin_filter();
  allow_without_bits(__NR_mmap, 2, 0x4 /* PROT_EXEC */);
  allow_without_bits(__NR_mprotect, 2, 0x4 /* PROT_EXEC */);
  return end_filter();
}
