/// Dialog of tests in many rooms: the choices, the progress, and the report.

import type {VNode} from "preact"
import type {RoomTest} from "../../jobs/room_test.ts"
import {isTestRoomShown} from "../../state/page_state.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {Dialog} from "../../ui/controls.tsx"
import {words} from "../../words/index.ts"
import {RoomTestForm} from "./room_test_form.tsx"
import {RoomTestReport} from "./room_test_report.tsx"

export function RoomTestDialog(): VNode {
  return (
    <Dialog name="room-tests" title={words.roomTests.title} lead={words.roomTests.lead}>
      {() => <Contents />}
    </Dialog>
  )
}

function Contents(): VNode {
  const {roomTests} = useController()
  const test = roomTests.test.value
  return (
    <div class="room-tests-body">
      <RoomTestForm />
      <p role="status" class="room-test-status">
        {status(test)}
      </p>
      {test.kind === "running" && <progress max={test.rooms} value={test.done} aria-hidden="true" />}
      <Back />
      {test.kind === "reported" && <RoomTestReport report={test.report} />}
    </div>
  )
}

/// Where the test is; the sentence is also for a screen reader.
function status(test: RoomTest): string {
  const w = words.roomTests
  switch (test.kind) {
    case "none":
      return ""
    case "waiting":
      return test.place > 0 ? w.queued(test.place) : w.waiting
    case "running":
      return test.shrunk > 0 ? w.shrinking(test.shrunk) : w.progress(test.done, test.rooms, test.passed)
    case "failed":
      return test.message ?? w.lost
    case "reported": {
      const {passed, rooms, problems} = test.report
      if (problems.length > 0) return `${w.refused} ${problems.join(" ")}`
      return passed === rooms.length ? w.allPassed(passed) : w.passed(passed, rooms.length)
    }
  }
}

/// Brings the learner's own room back that a room of a test has replaced.
function Back(): VNode | null {
  const {roomTests} = useController()
  const isReplaced = usePageState(isTestRoomShown)
  if (!isReplaced) return null
  return (
    <p>
      <button type="button" class="plain" onClick={() => roomTests.backToOwnRoom()}>
        {words.roomTests.back}
      </button>
    </p>
  )
}
