/* Guardian process of a connection to a base. Rosy.Robots.Guardian is its Haskell side. */
#ifndef ROSY_GUARDIAN_H
#define ROSY_GUARDIAN_H

/* Starts it. The line is an open descriptor that does not block: a serial line, or a socket, on which a stop is repeated for a second only. Gives its process number and the descriptor for heartbeats; -1 and errno on failure. */
int rosy_guardian_start(int line, const unsigned char *stop, int length, int timeout_ms, int *heartbeat);

/* One heartbeat; -1 when the guardian has ended. */
int rosy_guardian_beat(int heartbeat);

/* Makes it end; returns then. On a serial line it sends a stop first; the owner of a socket says goodbye by itself. */
void rosy_guardian_end(int guardian, int heartbeat);

#endif
