/* Guardian process of a serial line. Rosy.Robots.Guardian is its Haskell side. */
#ifndef ROSY_GUARDIAN_H
#define ROSY_GUARDIAN_H

/* Starts it. The line is an open descriptor that does not block. Gives its process number and the descriptor for heartbeats; -1 and errno on failure. */
int rosy_guardian_start(int line, const unsigned char *stop, int length, int timeout_ms, int *heartbeat);

/* One heartbeat; -1 when the guardian has ended. */
int rosy_guardian_beat(int heartbeat);

/* Makes it send a stop and end; returns then. */
void rosy_guardian_end(int guardian, int heartbeat);

#endif
