/// Line of the class bar about editing together: the teacher's question, that it is going on, and that it has ended.

import type {VNode} from "preact"
import {words} from "../../../words/index.ts"
import type {Sharing} from "../class_state.ts"
import type {SharingCommands} from "../pupil_sharing.ts"

interface Props extends SharingCommands {
  readonly sharing: Sharing
}

export function SharingLine({sharing, allowSharing, declineSharing, endSharing}: Props): VNode {
  const w = words.classroom.sharing
  return (
    <div class="class-sharing" data-testid="class-sharing">
      {sharing.kind === "asked" ? (
        <>
          <span role="alert">{w.asked(sharing.name || words.unnamed)}</span>
          <button type="button" class="plain" onClick={allowSharing}>
            {w.allow}
          </button>
          <button type="button" class="plain" onClick={declineSharing}>
            {w.decline}
          </button>
        </>
      ) : (
        <>
          <span role="status">
            {sharing.kind === "on"
              ? w.on
              : sharing.kind === "gone"
                ? w.gone(sharing.name || words.unnamed)
                : w.ended}
          </span>
          {sharing.kind === "on" && sharing.line !== null && (
            <span class="quiet">{w.teacherLine(sharing.line)}</span>
          )}
          <button type="button" class="plain" onClick={endSharing}>
            {sharing.kind === "on" ? w.end : w.close}
          </button>
        </>
      )}
    </div>
  )
}
