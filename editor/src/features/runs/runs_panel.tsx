/// Runs panel: the tree of the runs in this room with a picture of each, the choice of a run to compare with, and the two runs side by side.

import type {VNode} from "preact"
import {useLayoutEffect, useRef, useState} from "preact/hooks"
import {mayOpenRecording} from "../../reducers/recording_reducer.ts"
import {awayRun, mayShowRuns} from "../../reducers/run_tree_reducer.ts"
import type {RoomState} from "../../state/runs/room_state.ts"
import {isActive} from "../../state/runs/run_state.ts"
import {comparedRun, nodeOf, type RunRow, runName, runRows} from "../../state/runs/run_tree.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {goalTitle} from "../../ui/descriptions.ts"
import {drawThumbnail} from "../../views/room/world_drawing.ts"
import type {Goal} from "../../wire/page/runs.generated.ts"
import {measures, words} from "../../words/index.ts"
import {wordedText} from "../../words/worker_sentences.ts"
import {changeSentence} from "./change_sentence.ts"
import {factsOf, picturePath} from "./run_facts.ts"

/// Rows deeper than this are indented like this one: the tree fits on a phone.
const deepest = 6

export function RunsPanel(): VNode {
  const tree = usePageState(s => s.runTree)
  if (tree.nodes.length === 0)
    return (
      <div class="runs">
        <p class="quiet">{words.runs.empty}</p>
        <Recordings />
      </div>
    )
  return (
    <div class="runs" data-testid="runs">
      <Tree />
      <ProgramOfRun />
      {tree.dropped > 0 && <p class="quiet">{words.runs.dropped(tree.dropped)}</p>}
      {tree.nodes.length > 1 && <Comparison />}
      <Recordings />
    </div>
  )
}

function Tree(): VNode {
  const {store} = useController()
  const tree = usePageState(s => s.runTree)
  const shown = usePageState(s => s.room.run)
  const mayChoose = usePageState(mayShowRuns)
  const away = usePageState(s => awayRun(s)?.run ?? null)
  const rows = runRows(tree)
  const items = useRef<HTMLDivElement>(null)
  const first = Math.max(
    0,
    rows.findIndex(({node}) => node.run === shown),
  )
  // The row that the keyboard is at; the shown one until it has been moved.
  const [moved, move] = useState<number | null>(null)
  const at = moved === null || moved >= rows.length ? first : moved
  const go = (to: number) => {
    const row = Math.min(rows.length - 1, Math.max(0, to))
    move(row)
    items.current?.querySelectorAll<HTMLElement>("[role=treeitem]")[row]?.focus()
  }
  const keys: Readonly<Record<string, () => void>> = {
    ArrowDown: () => go(at + 1),
    ArrowUp: () => go(at - 1),
    Home: () => go(0),
    End: () => go(rows.length - 1),
    ArrowLeft: () => go(parentOf(rows, at)),
    ArrowRight: () => go((rows[at + 1]?.level ?? 0) > (rows[at]?.level ?? 0) ? at + 1 : at),
    Enter: () => choose(rows[at]),
    " ": () => choose(rows[at]),
  }
  const choose = (row: RunRow | undefined) => {
    if (row !== undefined) store.dispatch({kind: "run-shown", run: row.node.run})
  }
  return (
    <>
      <p class="quiet" id="runs-hint">
        {mayChoose ? words.runs.choose : words.runs.isRunning}
      </p>
      <div class="run-tree" role="tree" aria-label={words.tabs.runs} aria-describedby="runs-hint" ref={items}>
        {rows.map((row, i) => (
          <Row
            key={row.node.run}
            row={row}
            isShown={row.node.run === shown}
            isCompared={row.node.run === tree.compared}
            isTabStop={i === at}
            isAway={row.node.run === away}
            isDisabled={!mayChoose}
            focused={() => move(i)}
            choose={() => choose(row)}
            pressed={event => {
              const act = keys[event.key]
              if (act === undefined || event.ctrlKey || event.altKey || event.metaKey) return
              event.preventDefault()
              event.stopPropagation()
              act()
            }}
          />
        ))}
      </div>
    </>
  )
}

/// Where the newest run on a real robot is recorded, and how recordings are opened.
function Recordings(): VNode {
  const controller = useController()
  const recorded = usePageState(s => s.recorded)
  const mayOpen = usePageState(mayOpenRecording)
  const w = words.recordings
  return (
    <div class="recordings">
      {recorded !== null && <p class="quiet">{w.where(recorded.file)}</p>}
      <p>
        {recorded !== null && (
          <button
            type="button"
            class="plain"
            disabled={!mayOpen}
            onClick={() => controller.store.dispatch({kind: "recording-wanted", of: recorded.run})}
          >
            {w.again}
          </button>
        )}
        <button
          type="button"
          class="plain"
          title={w.openHint}
          disabled={!mayOpen}
          onClick={controller.openRecording}
        >
          {w.open}
        </button>
      </p>
    </div>
  )
}

/// The offer of the program of the shown run, when the open program is another one.
function ProgramOfRun(): VNode | null {
  const controller = useController()
  const shown = usePageState(s => nodeOf(s.runTree, s.room.run))
  const text = usePageState(s => s.document.program.text)
  const w = words.runs
  if (shown === undefined || shown.text === text) return null
  return (
    <p class="run-program">
      {w.otherProgram(shown.number)}{" "}
      <button type="button" class="plain" onClick={() => controller.showProgram(shown.text)}>
        {w.showProgram}
      </button>
    </p>
  )
}

/// The row above that a row is below of; the row itself for the first level.
function parentOf(rows: readonly RunRow[], at: number): number {
  const level = rows[at]?.level ?? 1
  const above = rows.slice(0, at).findLastIndex(row => row.level < level)
  return above < 0 ? at : above
}

function Row(props: {
  readonly row: RunRow
  readonly isShown: boolean
  readonly isCompared: boolean
  /// Whether it stands still until the learner returns to it.
  readonly isAway: boolean
  readonly isTabStop: boolean
  readonly isDisabled: boolean
  focused(): void
  choose(): void
  pressed(event: KeyboardEvent): void
}): VNode {
  const {row, isShown, isCompared, isAway} = props
  const {node, continued, changes} = row
  const room = usePageState(s => node.kept?.room ?? s.room)
  const {length, goals} = factsOf(room)
  const w = words.runs
  const isChanged = changes !== null && (continued === null || changes.length > 0)
  return (
    <div
      role="treeitem"
      class="run-row"
      aria-level={row.level}
      aria-posinset={row.place}
      aria-setsize={row.siblings}
      aria-selected={isShown}
      aria-disabled={props.isDisabled && !isShown}
      tabIndex={props.isTabStop ? 0 : -1}
      style={{"--level": Math.min(deepest, row.level) - 1}}
      onFocus={props.focused}
      onClick={props.choose}
      onKeyDown={props.pressed}
    >
      <PathPicture room={room} isLive={node.kept === null} />
      <span class="run-words">
        <span>
          <strong>{runName(node, words)}</strong>{" "}
          {continued !== null && w.continued(continued.number, continued.at)}
          {node.recorded && words.recordings.on(node.recorded)}
        </span>
        {isChanged && <span>{changeSentence(changes, w.changes)}</span>}
        <span class="quiet">
          {measures.seconds(length, 1)}
          {goals.length > 0 && ` · ${w.goals(doneIn(goals), goals.length)}`}
          {isCompared && ` · ${w.compared}`}
          {isAway && ` · ${w.paused}`}
        </span>
      </span>
    </div>
  )
}

const doneIn = (goals: readonly Goal[]) => goals.filter(({state}) => state === "done").length

/// The room with the path. While the run goes on it is drawn once a second.
function PathPicture({room, isLive}: {readonly room: RoomState; readonly isLive: boolean}): VNode {
  const canvas = useRef<HTMLCanvasElement>(null)
  const theme = usePageState(s => s.theme)
  const active = usePageState(s => isActive(s.run))
  const second = isLive && active ? Math.floor(room.frame?.time ?? 0) : room.trail
  useLayoutEffect(() => {
    if (canvas.current !== null && room.world !== null)
      drawThumbnail(canvas.current, room.world, picturePath(room.trail), [], room.ink)
  }, [second, room.world, theme])
  return <canvas ref={canvas} />
}

function Comparison(): VNode {
  const {store} = useController()
  const tree = usePageState(s => s.runTree)
  const shown = usePageState(s => s.room.run)
  const w = words.runs
  const others = tree.nodes.filter(({run, kept}) => run !== shown && kept !== null)
  return (
    <>
      <p class="run-compare">
        <label for="run-compare">{w.compare}</label>
        <select
          id="run-compare"
          value={tree.compared === null ? "" : String(tree.compared)}
          onChange={event => {
            const {value} = event.currentTarget
            store.dispatch({kind: "run-compared", run: value === "" ? null : Number(value)})
          }}
        >
          <option value="">{w.none}</option>
          {others.map(node => (
            <option key={node.run} value={String(node.run)}>
              {runName(node, words)}
            </option>
          ))}
        </select>
      </p>
      <ComparedFacts />
    </>
  )
}

/// Length, way and goals of both runs.
function ComparedFacts(): VNode | null {
  const tree = usePageState(s => s.runTree)
  const room = usePageState(s => s.room)
  const w = words.runs
  const other = comparedRun(tree)
  const own = nodeOf(tree, room.run)
  if (other === null || own === undefined) return null
  const [left, right] = [factsOf(room), factsOf(other.kept.room)]
  return (
    <table class="run-facts" data-testid="run-facts">
      <caption>{w.both}</caption>
      <thead>
        <tr>
          <td />
          <th scope="col">
            {runName(own, words)} <span class="quiet">({w.lines.shown})</span>
          </th>
          <th scope="col">
            {runName(other, words)} <span class="quiet">({w.lines.compared})</span>
          </th>
        </tr>
      </thead>
      <tbody>
        <tr>
          <th scope="row">{w.length}</th>
          <td>{measures.seconds(left.length, 1)}</td>
          <td>{measures.seconds(right.length, 1)}</td>
        </tr>
        <tr>
          <th scope="row">{w.way}</th>
          <td>{measures.metres(left.way)}</td>
          <td>{measures.metres(right.way)}</td>
        </tr>
        {left.goals.map((goal, i) => (
          <tr key={`${i} ${goal.title}`}>
            <th scope="row">{goal.title === "" ? goalTitle(goal.kind) : wordedText(goal.title)}</th>
            <td>{goalText(goal)}</td>
            <td>{goalText(right.goals[i])}</td>
          </tr>
        ))}
      </tbody>
    </table>
  )
}

function goalText(goal: Goal | undefined): string {
  const w = words.runs.goalStates
  return goal === undefined || goal.state === "open" || goal.time === null ? w.open : w[goal.state](goal.time)
}
