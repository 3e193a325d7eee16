/* System calls of the worker that Haskell's libraries do not offer. See rosy_sys.c. */
#ifndef ROSY_SYS_H
#define ROSY_SYS_H
#include <stdint.h>
#include <sys/types.h>

/* Receiving and sending. */
ssize_t rosy_receive(int fd, void *buffer, size_t size, int received_fds[2]);
ssize_t rosy_send(int fd, const void *buffer, size_t size);
int rosy_send_link(int fd, const void *buffer, size_t size, int count, const int *passed);

/* Waiting. */
int rosy_watch_children(void);
void rosy_drain(int fd);
int rosy_poll(int count, const int *fds, const short *wants, short *got, int milliseconds);
pid_t rosy_reap(int *how, int *value);
double rosy_processor_time(int pid);

/* Sharing. */
void *rosy_page(void);
void rosy_page_free(void *page);
void rosy_page_keep(void *page);
int rosy_pair(int *ends);
int rosy_write_all(int fd, const char *buffer, size_t size);

/* Becoming a child. */
int rosy_drop_capabilities(void);
int rosy_child_begin(int count, const int *keep, int null_fd, int no_files, int no_privileges);
int rosy_protect_memory(void);
void rosy_map_code(int fd);
int rosy_name(const char *name);
int rosy_nice(int niceness);
int rosy_filter_compiling(void);
int rosy_filter_running(void);
int rosy_limit_data(uint64_t bytes);
int rosy_limit_process(uint64_t data_bytes, int alone);
void rosy_limit_heap(uint64_t bytes);
void rosy_compact_begin(void);
void rosy_compact_end(void);
uint64_t rosy_data_size(void);
uint64_t rosy_anonymous_memory(int pid);
uint64_t rosy_machine_memory(void);
void rosy_area(uint64_t bytes);
void rosy_area_clear(void);
void rosy_stay_young(int stay);
void rosy_free_clear(void);
void rosy_fresh_begin(uint64_t area);
void rosy_fresh_end(void);
void rosy_exit(int code);
#endif
