/// Questions about a node of the diagram at a moment of the run. Pure.

import {odometry} from "@rosy/codegen/roles"
import {lookedBackFor, motionQuestion, type Question} from "../state/messages/why_state.ts"

/// `time` is the displayed moment, s.
export function nodeQuestions(
  {kind, key}: {readonly kind: string; readonly key: string},
  time: number,
): readonly Question[] {
  const since = Math.max(0, time - lookedBackFor)
  // Parameters of a type are no part of a constructor or a channel.
  const name = key.split(" ")[0] ?? key
  switch (kind) {
    case "function":
      return [
        {kind: "run", function: key, time},
        {kind: "not", function: key, command: "", since, until: time},
      ]
    case "event":
      return [{kind: "event", value: name, time}]
    case "channel":
      return [
        {kind: "event", value: name, time},
        {kind: "not-received", type: key, since: 0, until: time},
      ]
    case "state":
      // What the robot measures of its own motion comes from the commands that move it.
      if (name === "Velocity") return [motionQuestion(time)]
      return odometry.has(name) ? [{kind: "position", time}] : []
    case "store":
      return [{kind: "memory", type: key, time}]
    case "command":
      return [
        {kind: "command", command: name, value: "", time},
        {kind: "no-command", command: name, since, until: time},
      ]
    default:
      return []
  }
}
