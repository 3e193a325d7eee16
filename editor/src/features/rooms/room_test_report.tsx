/// Report of a test in many rooms: the smallest failing room, and a table of the failures, worst first.

import type {VNode} from "preact"
import type {Answer, Smallest, TestedRoom} from "../../jobs/room_test.ts"
import {useController} from "../../ui/app_context.ts"
import {words} from "../../words/index.ts"
import {happened, Picture} from "./tested_room.tsx"

/// Failures with a picture; of the others only the number is shown.
const mostPictures = 12

export function RoomTestReport({report}: {readonly report: Answer & {readonly op: "report"}}): VNode | null {
  const failures = report.rooms.filter(room => !room.passed)
  if (failures.length === 0) return null
  return (
    <>
      {report.smallest !== null && <SmallestRoom smallest={report.smallest} />}
      <Failures failures={failures} />
    </>
  )
}

function SmallestRoom({smallest}: {readonly smallest: Smallest}): VNode {
  const {roomTests} = useController()
  const w = words.roomTests
  return (
    <section class="smallest-room" aria-labelledby="smallest-room">
      <Picture tested={smallest.tested} />
      <div>
        <h3 id="smallest-room">{w.smallest}</h3>
        <p>{happened(smallest.tested)}</p>
        {smallest.of > 0 && <p class="quiet">{w.things(smallest.things, smallest.of)}</p>}
        <button type="button" class="plain primary" onClick={() => roomTests.openRoom(smallest.tested)}>
          {w.openSmallest}
        </button>
      </div>
    </section>
  )
}

function Failures({failures}: {readonly failures: readonly TestedRoom[]}): VNode {
  const {roomTests} = useController()
  const w = words.roomTests
  return (
    <>
      <table class="room-test-table">
        <caption>{w.failures}</caption>
        <thead>
          <tr>
            <th scope="col">{w.picture}</th>
            <th scope="col">{w.room}</th>
            <th scope="col">{w.what}</th>
            <td />
          </tr>
        </thead>
        <tbody>
          {failures.slice(0, mostPictures).map(tested => (
            <tr key={tested.room}>
              <td>
                <Picture tested={tested} />
              </td>
              <th scope="row">{tested.room}</th>
              <td>{happened(tested)}</td>
              <td>
                <button
                  type="button"
                  class="plain"
                  aria-label={w.openNamed(tested.room)}
                  onClick={() => roomTests.openRoom(tested)}
                >
                  {w.open}
                </button>
              </td>
            </tr>
          ))}
        </tbody>
      </table>
      {failures.length > mostPictures && <p class="quiet">{w.more(failures.length - mostPictures)}</p>}
    </>
  )
}
