/// Note over the room: how a real robot and the simulated one beside it differed, once their run is over or while it is looked back at.

import type {VNode} from "preact"
import type {PageState} from "../../state/page_state.ts"
import {isActive} from "../../state/runs/run_state.ts"
import {comparedRun, nodeOf} from "../../state/runs/run_tree.ts"
import {usePageState} from "../../ui/app_context.ts"
import {measures, words} from "../../words/index.ts"
import {type Differences, differences} from "./differences.ts"
import {twinSentence} from "./twin_sentence.ts"

export function TwinNote(): VNode {
  const sentence = usePageState(s => {
    const found = twinDifferences(s)
    return found === null ? "" : twinSentence(found, words.twin, measures)
  })
  return (
    <p class={sentence === "" ? "hidden-text" : "preview-note"} aria-live="polite" data-testid="twin-note">
      {sentence !== "" && <span class="twin-line" />}
      {sentence}
    </p>
  )
}

/// `null` unless the room shows a real run and its twin, and both stand.
export function twinDifferences({room, runTree, run}: PageState): Differences | null {
  const [shown, other] = [nodeOf(runTree, room.run), comparedRun(runTree)]
  if (shown === undefined || other === null || (isActive(run) && room.lookedAt === null)) return null
  const [own, kept] = [room.recording, other.kept.room.recording]
  if (shown.twin === "real" && other.from?.run === shown.run) return differences(own, kept, room.lookedAt)
  if (shown.twin === "simulated" && shown.from?.run === other.run)
    return differences(kept, own, room.lookedAt)
  return null
}
