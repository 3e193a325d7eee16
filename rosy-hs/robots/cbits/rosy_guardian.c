/*
 * Guardian process of a connection to a base, a serial line or a socket: stops the base when the process that drives it ends or stands still.
 *
 * In: heartbeats, single bytes on a pipe. Out: the bytes of a stop on the line, when no heartbeat has come for the timeout, again
 * every REPEAT_MS until one comes (on a socket, whose other end others may drive too, MAX_REPEATS times), and once when the pipe is closed; then it ends. It is forked and not executed, so it needs no
 * program of its own, and uses only calls that are async-signal-safe (POSIX.1-2017, 2.4.3), because other threads of the
 * parent may hold locks at the fork.
 */
#define _GNU_SOURCE
#include "rosy_guardian.h"

#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#ifndef SYS_close_range
#define SYS_close_range 436 /* the number on every architecture; Debian 11's headers lack it */
#endif

enum { REPEAT_MS = 100, MAX_REPEATS = 10, DRAIN_MS = 1000, MAX_STOP = 1024, LINE = 3, PIPE = 4, FIRST_OTHER = 5, MAX_FDS = 65536, GOODBYE = 'g' };

static long now_ms(void) {
  struct timespec t;
  clock_gettime(CLOCK_BOOTTIME, &t); /* a computer that slept was silent */
  return t.tv_sec * 1000L + t.tv_nsec / 1000000L;
}

static void send_stop(const unsigned char *stop, int length) {
  /* The line does not block. What is not taken is sent again, or the line is gone. */
  ssize_t n = write(LINE, stop, (size_t)length);
  (void)n;
}

static void ignore_signals(void) {
  /* Those by which a terminal, a shell or ./rosy ends or suspends programs. */
  static const int ignored[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGUSR1, SIGUSR2, SIGALRM, SIGVTALRM, SIGTSTP, SIGTTIN, SIGTTOU};
  struct sigaction ignore;
  memset(&ignore, 0, sizeof ignore);
  ignore.sa_handler = SIG_IGN;
  for (unsigned i = 0; i < sizeof ignored / sizeof *ignored; i++) sigaction(ignored[i], &ignore, 0);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, 0);
}

static int is_socket(int fd) {
  struct stat s;
  return fstat(fd, &s) == 0 && S_ISSOCK(s.st_mode);
}

static void drain(void) {
  /* A socket that is closed with unread bytes is reset, and the other side may lose the stop. */
  char bytes[4096];
  long until = now_ms() + DRAIN_MS;
  shutdown(LINE, SHUT_WR);
  for (long left = DRAIN_MS; left > 0; left = until - now_ms()) {
    struct pollfd line = {LINE, POLLIN, 0};
    if (poll(&line, 1, (int)left) <= 0 || read(LINE, bytes, sizeof bytes) <= 0) return;
  }
}

static void keep_watch(const unsigned char *stop, int length, int timeout_ms) {
  int on_socket = is_socket(LINE), repeats = 0;
  long due = now_ms() + timeout_ms;
  for (;;) {
    long left = due - now_ms();
    struct pollfd heartbeat = {PIPE, POLLIN, 0};
    int resting = on_socket && repeats == MAX_REPEATS;
    int ready = poll(&heartbeat, 1, resting ? -1 : left > 0 ? (int)left : 0);
    if (ready < 0 && errno != EINTR) break;
    if (ready > 0) {
      char bytes[256];
      ssize_t n = read(PIPE, bytes, sizeof bytes);
      if (n == 0 || (n < 0 && errno != EINTR)) break;
      if (n > 0 && bytes[n - 1] == GOODBYE && on_socket) return;
      /* After a sleep of the computer the heartbeat may come before the timeout is seen. */
      if (now_ms() > due && repeats == 0) send_stop(stop, length);
      repeats = 0;
      due = now_ms() + timeout_ms;
    } else if (ready == 0) {
      send_stop(stop, length);
      repeats++;
      due = now_ms() + REPEAT_MS;
    }
  }
  send_stop(stop, length);
  if (on_socket) drain();
}

int rosy_guardian_start(int line, const unsigned char *stop, int length, int timeout_ms, int *heartbeat) {
  int ends[2];
  unsigned char kept[MAX_STOP];
  if (length > MAX_STOP) {
    errno = EINVAL;
    return -1;
  }
  memcpy(kept, stop, (size_t)length);
  if (pipe2(ends, O_CLOEXEC | O_NONBLOCK) < 0) return -1;
  pid_t child = fork();
  if (child == 0) {
    ignore_signals();
    /* Away from the terminal's and the parent's group, so that what is sent to a group does not reach both. */
    setsid();
    prctl(PR_SET_NAME, "rosy-guardian");
    /* Both descriptors to fixed places, by places that neither may have yet; everything else is closed. */
    int line_copy = fcntl(line, F_DUPFD, FIRST_OTHER), pipe_copy = fcntl(ends[0], F_DUPFD, FIRST_OTHER);
    dup2(line_copy, LINE);
    dup2(pipe_copy, PIPE);
    if (syscall(SYS_close_range, FIRST_OTHER, ~0U, 0) < 0)
      for (int fd = FIRST_OTHER; fd < MAX_FDS; fd++) close(fd);
    for (int fd = 0; fd < LINE; fd++) close(fd);
    keep_watch(kept, length, timeout_ms);
    _exit(0);
  }
  int why = errno;
  close(ends[0]);
  if (child < 0) {
    close(ends[1]);
    errno = why;
    return -1;
  }
  *heartbeat = ends[1];
  return child;
}

int rosy_guardian_beat(int heartbeat) {
  ssize_t n;
  do n = write(heartbeat, "b", 1);
  while (n < 0 && errno == EINTR);
  /* A full pipe: the guardian stands still. That is no reason to stop the base while the parent runs. */
  return n < 0 && errno != EAGAIN ? -1 : 0;
}

void rosy_guardian_end(int guardian, int heartbeat) {
  char goodbye = GOODBYE;
  ssize_t n = write(heartbeat, &goodbye, 1);
  (void)n;
  close(heartbeat);
  kill(guardian, SIGCONT); /* a suspended one would be waited for without end */
  while (waitpid(guardian, 0, 0) < 0 && errno == EINTR) continue;
}
