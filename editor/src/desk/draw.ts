/// Draws what is not Preact's: blocks, text and room, each told only of what changed for it.

import type {BlocksView} from "../blocks/index.ts"
import type {RoomView} from "../room/view.ts"
import type {Liking} from "../run/storage.ts"
import type {SourcePane} from "../source/pane.ts"
import type {PageState} from "../state/page.ts"
import {believed} from "../state/page.ts"
import {textOf} from "../state/program.ts"
import {glowing} from "../state/room.ts"
import {isActive} from "../state/run.ts"
import {blockProblem} from "./programs.ts"

/// What the browser remembers of how the learner likes the page.
const liked = ["theme", "muted", "arrangement", "layout", "trail", "charts", "chartSpan"] as const

export function drawParts(
  parts: () => {blocks: BlocksView | null; source: SourcePane | null; room: RoomView | null},
  /// Whether something was typed that the program does not have yet.
  typing: () => boolean,
  again: () => void,
  paint: () => void,
  remember: (liking: Liking) => void,
): (state: PageState, now: number) => void {
  let before: PageState | null = null
  let glow = ""
  return (state, now) => {
    const {blocks, source, room} = parts()
    const changed = (key: keyof PageState) => before === null || before[key] !== state[key]
    const {program} = state.document
    if (changed("document")) {
      // What was typed since is newer than the program: it would be lost.
      if (!typing()) source?.setProgram(program)
      blocks?.dim(state.document.dimmed)
    }
    if (changed("findings") || changed("document") || changed("accepted") || changed("run")) {
      const {compiler, run} = state.findings
      source?.mark([...believed(state), ...compiler, ...run])
      // While somebody builds, an empty socket is no mistake: it is drawn dashed. Only Run makes it one.
      const tried = state.run.kind === "ended" && state.run.how === "refused"
      const shown = [...compiler.filter(f => tried || f.kind !== "hole"), ...run]
      blocks?.mark(shown.map(blockProblem), state.accepted)
    }
    if (changed("declared") || changed("types"))
      source?.setTold({declared: state.declared, types: state.types})
    if (changed("selected") || changed("selectedIn") || changed("document")) {
      const {selected, selectedIn} = state
      source?.link(selected === null ? null : textOf(program.spans, selected))
      blocks?.highlight(selected === null || selectedIn === "blocks" ? [] : [selected])
      if (selected !== null && selectedIn === "haskell") blocks?.reveal(selected)
    }
    if (changed("room") || changed("run")) {
      const names = isActive(state.run) ? glowing(state.room) : []
      if (names.length > 0) blocks?.glow(names)
      if (names.join(" ") !== glow) {
        glow = names.join(" ")
        source?.glow(program.definitions.filter(d => names.includes(d.name)))
      }
    }
    if (changed("theme")) paint()
    if (before !== null && liked.some(changed))
      remember(Object.fromEntries(liked.map(key => [key, state[key]])))
    before = state
    const sight = {
      trail: state.trail,
      follows: state.follows,
      hands: state.run.kind === "running" && state.robots.held === null,
      held: state.room.held,
    }
    if (room?.draw(state.room, sight, now)) again()
  }
}
