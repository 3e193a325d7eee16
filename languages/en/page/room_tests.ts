/// Words of the dialog that tests a program in many rooms.

import {measuresOf} from "../../../editor/src/words/number_formats.ts"

const {short, seconds, metres, count} = measuresOf("en")

export const roomTests = {
  menu: "Test in many rooms…",
  title: "Test in many rooms",
  lead: "Does your program work in rooms that it has never seen?",
  hold: "This has to hold in every room:",
  properties: {
    "reaches-goal": "It reaches the goal",
    "never-falls": "It never falls into a hole",
    "never-pushes": "It never pushes against something for longer than",
    "returns-to-start": "It leaves its start and comes back",
    covers: "It passes over this much of the floor:",
    "room-goals": "It does all that the room asks for",
  },
  units: {"never-pushes": "seconds", covers: "percent"},
  family: "Rooms",
  families: {obstacles: "with obstacles", maze: "mazes", pits: "with holes", like: "like the room here"},
  howMany: "How many",
  start: "Test",
  otherRooms: "Test in other rooms",
  cancel: "Stop the test",
  noProperty: "Choose something that has to hold.",
  noConnection: "Rosy is not connected. It tries again by itself.",
  lost: "The connection was lost, and the test with it. Try again.",
  waiting: "The test starts…",
  queued: (place: number) => `Others are testing. Your place in the line is ${place}.`,
  progress: (done: number, rooms: number, passed: number) => `${done} of ${rooms} rooms, ${passed} passed`,
  shrinking: (tried: number) =>
    `Looking for the smallest room in which it fails: ${count(tried, {one: "one room tried", other: n => `${n} rooms tried`})}`,
  refused: "The program cannot run yet:",
  allPassed: (rooms: number) => `It works in all ${rooms} rooms.`,
  passed: (passed: number, rooms: number) => `It works in ${passed} of ${rooms} rooms.`,
  smallest: "The smallest room in which it fails",
  things: (things: number, of: number) =>
    things === 0
      ? "It fails even when the room is empty."
      : things === of
        ? "Nothing in it can be left out."
        : `Of ${of} things ${count(things, {one: "only one is", other: n => `${n} are`})} needed for that.`,
  openSmallest: "Open it and run",
  failures: "Rooms in which it fails, worst first",
  picture: "Picture",
  room: "Room",
  what: "What happened",
  open: "Open and run",
  openNamed: (room: number) => `Open room ${room} and run`,
  more: (n: number) => count(n, {one: "One more room fails.", other: m => `${m} more rooms fail.`}),
  back: "Back to my room",
  /// What happened in a room, by the property that failed.
  found: {
    "reaches-goal": (share: number) => `It came ${short(share * 100, 0)} % of the way to the goal.`,
    "never-falls": (time: number) => `It fell after ${seconds(time, 1)}.`,
    "never-pushes": (push: number, time: number) =>
      `It pushed for ${seconds(push, 1)}, until ${seconds(time, 1)} after the start.`,
    "returns-to-start": (distance: number) =>
      distance === 0 ? "It stayed near its start." : `It came back only to ${metres(distance)}.`,
    covers: (share: number) => `It passed over ${short(share, 0)} % of the floor.`,
    "room-goals": (share: number) => `It did ${short(share * 100, 0)} % of what the room asks for.`,
  },
}
