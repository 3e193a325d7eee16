/// Tests in many rooms for the page: the choices and the test of the dialog, and what its buttons do.

import {type Signal, signal} from "@preact/signals"
import type {Store} from "../browser/store.ts"
import {startJob} from "./job_socket.ts"
import {
  type Choices,
  firstChoices,
  heard,
  isLast,
  type RoomTest,
  readAnswer,
  requestOf,
  type TestedRoom,
} from "./room_test.ts"

export interface RoomTests {
  readonly choices: Signal<Choices>
  readonly test: Signal<RoomTest>
  open(): void
  start(): void
  cancel(): void
  /// Takes a room and runs the program there, with the random seed of the test.
  openRoom(tested: TestedRoom): void
  /// Takes the room back that the page showed before.
  backToOwnRoom(): void
}

/// `flush` brings the text up to date with the blocks.
export function openRoomTests(store: Store, flush: () => void): RoomTests {
  const choices = signal(firstChoices)
  const test = signal<RoomTest>({kind: "none"})
  let cancelTest = () => {}

  return {
    choices,
    test,
    open: () => store.dispatch({kind: "dialog", dialog: "room-tests"}),
    start() {
      const {session} = store.now
      if (session === null) return
      flush()
      cancelTest()
      const request = requestOf(choices.value, store.now.document.program.text, store.now.room.world)
      test.value = {kind: "waiting", place: 0, rooms: choices.value.rooms}
      cancelTest = startJob(
        `room-tests/${encodeURIComponent(session)}`,
        request,
        {read: readAnswer, isLast},
        {
          received(answer) {
            test.value = heard(test.value, answer)
          },
          lost() {
            test.value = {kind: "failed", message: null}
          },
        },
      )
    },
    cancel() {
      cancelTest()
      test.value = {kind: "none"}
    },
    openRoom(tested) {
      store.dispatch({kind: "test-room-opened", world: tested.world})
      flush()
      store.dispatch({kind: "run-pressed", seed: tested.seed})
    },
    backToOwnRoom: () => store.dispatch({kind: "own-room-restored"}),
  }
}
