/// What stands beside a robot's name where one is chosen.

import type {Nearby, RobotName} from "../../wire/page/robots.generated.ts"
import {words} from "../../words/index.ts"

/// What a robot is, where it is and who has it, as far as that is known.
export function robotHint({name, holder, yours, nearby}: RobotName): string {
  const w = words.robots
  const found =
    nearby === null ? [] : [w.domain(nearby.domain), ...(nearby.zenoh ? ["Zenoh"] : []), ...battery(nearby)]
  const kind = nearby === null || name.startsWith(nearby.title) ? [] : [nearby.title]
  const who = yours ? w.yours : holder === null ? w.free : w.has(holder)
  const several = nearby?.several === true ? [w.several] : []
  return [...kind, ...found, who, ...several].join(" · ")
}

function battery({charge, volts}: Nearby): string[] {
  const w = words.robots
  if (charge !== null) return [w.charge(charge)]
  return volts === null ? [] : [w.volts(volts)]
}
