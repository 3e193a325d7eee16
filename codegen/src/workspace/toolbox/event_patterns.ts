/// Patterns of the robot's events, as the toolbox offers them and as its functions take them.

import {anything, match, pat} from "./block_builders.ts"

export const bumper = (status: string) => pat("Bumper", anything("side"), match("ButtonStatus", status))
export const leftBumper = pat("BumperLeft", match("ButtonStatus", "Pressed"))
export const cliff = (status: string) => pat("Cliff", anything("side"), match("CliffStatus", status))
export const wheel = pat("Wheel", anything("side"), match("WheelStatus", "Air"))
export const firstButton = pat("Button", match("ButtonNumber", "Button0"), match("ButtonStatus", "Pressed"))
