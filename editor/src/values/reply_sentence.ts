/// A reply of one of the robot's own programs as a sentence. In: the event as Haskell shows it (`Reply dock Aborted no dock is in sight.`, Rosy.Request).
/// Out: whose reply it is, as a program calls it, and the sentence; nothing for another event.

import {words} from "../words/index.ts"

export type ReplySentence = {readonly name: string; readonly text: string}

type Answer = "Feedback" | "Succeeded" | "Rejected" | "Aborted" | "Cancelled" | "Unavailable"

const replyPattern = /^Reply (\S+) (Feedback|Succeeded|Rejected|Aborted|Cancelled|Unavailable)(?: (.*))?$/s

/// What ROS says where the answer itself says as much: rosbridge_library, internal/actions.py and internal/services.py.
const emptyReason = /^No action server available$|^Action goal was rejected$|^Service \S+ does not exist$/

export function replySentence(event: string): ReplySentence | null {
  const [, name = "", answer, reason = ""] = replyPattern.exec(event) ?? []
  if (answer === undefined) return null
  const called = name.startsWith("/")
    ? name
    : name.replace(/_(.)/g, (_, letter: string) => letter.toUpperCase())
  const outcome =
    {...words.replies.succeeded}[answer === "Succeeded" ? called : ""] ?? words.replies[answer as Answer]
  const why = shortReason(reason)
  return {name: called, text: `${words.replies.answered} ${outcome}${why === "" ? "" : ` (${why})`}.`}
}

/// Why, without what the answer says already; what the simulated robot says is translated.
function shortReason(reason: string): string {
  if (emptyReason.test(reason)) return ""
  const short = reason.replace(/^(?:Aborted|Cancelled): /, "").replace(/\.$/, "")
  const known: Readonly<Record<string, string>> = words.replies.reasons
  return known[short] ?? short
}
