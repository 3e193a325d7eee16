/// Updates of the views that are not Preact components (blocks, text, room) from the state, each only when its input changed; and the list of all keyboard shortcuts.

import {pageKeys} from "../../browser/browser_window.ts"
import {locateComments} from "../../program/block_comments.ts"
import {textRangeOf} from "../../program/program.ts"
import type {Explanation} from "../../state/messages/why_state.ts"
import type {PageState} from "../../state/page_state.ts"
import {recentlyFired} from "../../state/runs/room_state.ts"
import {isActive} from "../../state/runs/run_state.ts"
import {runName} from "../../state/runs/run_tree.ts"
import {type KeySection, keyLines} from "../../state/shortcuts.ts"
import {compiled, trustedFindings} from "../../state/visible_findings.ts"
import type {Preferences} from "../../storage/stored_values.ts"
import {runningBlocks} from "../../values/running_blocks.ts"
import {blockKeys} from "../../views/blocks/interaction/shortcut_list.ts"
import {causalPath, noPath} from "../../views/diagram/network/causal_path.ts"
import {worldKeys} from "../../views/room/editor/world_editor_shortcuts.ts"
import {roomKeys} from "../../views/room/gestures.ts"
import {type Overlay, overlayOf} from "../../views/room/overlay.ts"
import {textKeys} from "../../views/source/shortcuts.ts"
import {words} from "../../words/index.ts"
import {blockProblem} from "../document/document_conversion.ts"
import type {PageParts} from "../document/page_parts.ts"
import {openValueUpdates} from "./value_updates.ts"

/// Keys of the state that are stored in the browser as the learner's preferences.
const preferenceKeys = [
  "theme",
  "muted",
  "arrangement",
  "layout",
  "trail",
  "charts",
  "chartSpan",
  "previewing",
  "valuesShown",
] as const

export function openViewUpdates(
  parts: PageParts,
  /// Whether an edit of the text is pending that the document does not have yet.
  isTyping: () => boolean,
  redraw: () => void,
  applyColours: () => void,
  setPreferences: (preferences: Preferences) => void,
): (state: PageState, now: number) => void {
  const updateValues = openValueUpdates(parts)
  let before: PageState | null = null
  let glow = ""
  /// A pending edit of the text kept them from being shown in it.
  let areCommentsBehind = false
  let explained: Explanation | null = null
  return (state, now) => {
    const {blocks, source, room} = parts
    const changed = (key: keyof PageState) => before === null || before[key] !== state[key]
    const {program} = state.document
    if (changed("document")) {
      // A pending edit is newer than the document and must not be overwritten.
      if (!isTyping()) source?.setProgram(program)
      blocks?.dim(state.document.dimmed)
    }
    if (changed("findings") || changed("document") || changed("accepted") || changed("refused")) {
      const {run} = state.findings
      const compiler = compiled(state)
      source?.mark([...trustedFindings(state), ...compiler, ...run])
      // An empty socket is drawn dashed; it is reported as a problem only after Run.
      const shown = [...compiler.filter(f => state.refused !== null || f.kind !== "hole"), ...run]
      blocks?.mark(shown.flatMap(blockProblem), state.accepted)
    }
    if (changed("declared") || changed("types"))
      source?.setTold({declared: state.declared, types: state.types})
    if (changed("selected") || changed("selectedIn") || changed("document")) {
      const {selected, selectedIn} = state
      source?.link(selected === null ? null : textRangeOf(program.spans, selected))
      blocks?.highlight(selected === null || selectedIn === "blocks" ? [] : [selected])
      if (selected !== null && selectedIn === "haskell") blocks?.reveal(selected)
    }
    const areCommentsMoved = changed("document") && state.blockComments.length > 0
    if (changed("blockComments") || areCommentsMoved || (areCommentsBehind && !isTyping())) {
      const located = locateComments(program, state.blockComments)
      const texts = located.map(({comment, range, block}) => ({
        range,
        block,
        text: `${words.classroom.task.comment} ${comment.text}`,
      }))
      areCommentsBehind = isTyping()
      if (!areCommentsBehind) source?.showComments(texts)
      blocks?.showComments(texts.flatMap(({block, text}) => (block === null ? [] : [{block, text}])))
    }
    if (changed("room") || changed("run") || changed("document")) {
      const isBack = state.room.lookedAt !== null
      const names = isActive(state.run) && !isBack ? recentlyFired(state.room) : []
      if (names.length > 0) blocks?.glow(names)
      const live = program.definitions.filter(d => names.includes(d.name))
      const running = isBack ? runningBlocks(state) : {blocks: [], ranges: live, isAtStep: false}
      const {blocks: ids, ranges} = running
      const shown = `${ids.join(" ")} ${ranges.map(({start}) => start).join(" ")}`
      if (shown !== glow) {
        glow = shown
        const [first] = ids
        // A block that was never in sight is made first, and can be marked then.
        if (running.isAtStep && first !== undefined) blocks?.reveal(first)
        blocks?.showRunning(ids)
        source?.glow(ranges)
      }
    }
    const answer = state.why.open?.answer ?? null
    if (answer !== explained || (answer !== null && changed("document"))) {
      explained = answer
      const names = answer === null ? noPath.functions : causalPath(answer).functions
      blocks?.explain([...names])
      source?.explain(program.definitions.filter(d => names.has(d.name)))
    }
    updateValues(state, now)
    if (changed("theme")) applyColours()
    if (before !== null && preferenceKeys.some(changed))
      setPreferences(Object.fromEntries(preferenceKeys.map(key => [key, state[key]])))
    before = state
    const overlay = overlayOf(state)
    const sight = {
      trail: state.trail,
      follows: state.follows,
      hands: state.run.kind === "running" && state.robots.held === null,
      held: state.room.held,
      companions: state.robots.held === null ? state.companions : noCompanions,
      overlay: overlay && {...overlay, names: namesOf(overlay)},
    }
    if (room?.draw(state.room, sight, now)) redraw()
  }
}

/// The same value at each drawing: a real robot has no others beside it.
const noCompanions: PageState["companions"] = []

/// The names beside two robots. Those of a real run and its twin are short.
function namesOf({shown, compared}: Overlay): {readonly shown: string; readonly compared: string} {
  const name = ({number, twin}: Overlay["shown"]) =>
    twin === undefined ? words.runs.run(number) : words.twin.names[twin]
  return shown.number === compared.number
    ? {shown: name(shown), compared: name(compared)}
    : {shown: runName(shown, words), compared: runName(compared, words)}
}

export function keySections(): readonly KeySection[] {
  const {sections, page, blocks, text, room, world} = words.keys
  return [
    {title: sections.page, lines: keyLines(page, pageKeys)},
    {title: sections.blocks, lines: keyLines(blocks, blockKeys())},
    {title: sections.text, lines: keyLines(text, textKeys)},
    {title: sections.room, lines: keyLines(room, roomKeys)},
    {title: words.world.title, lines: keyLines(world, worldKeys)},
  ]
}
