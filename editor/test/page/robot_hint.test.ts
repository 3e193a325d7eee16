/// What stands beside a robot where one is chosen.

import {expect, test} from "vitest"
import {robotHint} from "../../src/page/bars/robot_hint.ts"
import type {RobotName} from "../../src/wire/page/robots.generated.ts"

const robot: RobotName = {name: "Kitchen", holder: null, yours: false, nearby: null}
const found = {title: "TurtleBot 3", domain: 7, charge: null, volts: null, zenoh: false, several: false}

test.each<[Partial<RobotName>, string]>([
  [{}, "free"],
  [{holder: "Anna"}, "Anna has it"],
  [{holder: "Anna", yours: true}, "you have it"],
  [{nearby: found}, "TurtleBot 3 · ROS 2 domain 7 · free"],
  [{name: "TurtleBot 3 (ros2:7)", nearby: found}, "ROS 2 domain 7 · free"],
  [{nearby: {...found, zenoh: true}}, "TurtleBot 3 · ROS 2 domain 7 · Zenoh · free"],
  [
    {nearby: {...found, several: true}},
    "TurtleBot 3 · ROS 2 domain 7 · free · several robots on the same topics: give each a namespace",
  ],
  [{nearby: {...found, volts: 11.94}}, "TurtleBot 3 · ROS 2 domain 7 · battery 11.9 V · free"],
  [
    {nearby: {...found, charge: 0, volts: 11.9}, holder: "Anna"},
    "TurtleBot 3 · ROS 2 domain 7 · battery 0% · Anna has it",
  ],
])("%o: %s", (more, hint) => expect(robotHint({...robot, ...more})).toBe(hint))
