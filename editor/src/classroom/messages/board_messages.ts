/// Messages of the service to the teacher's board (protocol §11), with rooms and results as the board keeps them.

import {testedRoom} from "../../jobs/room_test.ts"
import {type BoardAnswer, boardAnswer} from "../../wire/classroom/board_messages.generated.ts"
import {mapped, readerOf} from "../../wire/decode.ts"
import type {World} from "../../worlds/world.ts"
import {worldAt} from "../../worlds/world_decoder.ts"
import {type CheckResult, checkResult, type RoomsOfResult} from "./hand_in_checks.ts"

export type BoardMessage =
  | Exclude<BoardAnswer, {readonly op: "room" | "rooms" | "result"}>
  | {readonly op: "room"; readonly pupil: number; readonly world: World}
  | ({readonly op: "rooms"} & RoomsOfResult)
  | {
      readonly op: "result"
      readonly task: number
      readonly pupil: number
      /// `null` when the pupil has handed in again.
      readonly result: CheckResult | null
    }

export const readBoardMessage = readerOf(
  mapped(boardAnswer, (message): BoardMessage => {
    switch (message.op) {
      case "room":
        return {...message, world: worldAt("world", message.world)}
      case "rooms":
        return {...message, rooms: message.rooms.map(testedRoom)}
      case "result":
        return {...message, result: message.result && checkResult(message.result)}
      default:
        return message
    }
  }),
)
