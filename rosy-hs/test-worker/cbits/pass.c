/* Sends bytes with one descriptor riding on them, as the service does with a run. */
#include <string.h>
#include <sys/socket.h>
#include <sys/uio.h>

long test_send_with(int socket, const char *bytes, unsigned long size, int passenger) {
  struct iovec part = {(void *)bytes, size};
  union { char space[CMSG_SPACE(sizeof(int))]; struct cmsghdr align; } control;
  struct msghdr message = {.msg_iov = &part, .msg_iovlen = 1, .msg_control = &control, .msg_controllen = sizeof control.space};
  struct cmsghdr *header = CMSG_FIRSTHDR(&message);
  header->cmsg_level = SOL_SOCKET;
  header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(sizeof(int));
  memcpy(CMSG_DATA(header), &passenger, sizeof(int));
  return sendmsg(socket, &message, MSG_NOSIGNAL);
}
