/// Replies of the robot's own programs in the console: the first word is whose reply it is.

export const replies = {
  answered: "answered:",
  Feedback: "still at work",
  Succeeded: "done",
  Rejected: "refused",
  Aborted: "given up",
  Cancelled: "stopped",
  Unavailable: "nobody here does that",
  succeeded: {dock: "docked", navigateTo: "arrived"},
  reasons: {
    "no dock is in sight": "no dock is in sight",
    "something is in the way": "something is in the way",
    "it took too long": "it took too long",
    "no way leads there": "no way leads there",
  },
}
