/// Tree of the runs in a room: which run each was continued from or followed, and what the page showed of it. Bounded: the oldest unused runs are dropped. Pure.

import type {Words} from "../../words/index.ts"
import {type ProgramChange, programChanges} from "./program_changes.ts"
import {type ConsoleLine, clearRoom, emptyRoom, type RoomState} from "./room_state.ts"

/// What the page shows of a run: frames, path, goals, and the lines of the console.
export interface ShownRun {
  readonly room: RoomState
  readonly lines: readonly ConsoleLine[]
}

export interface RunNode {
  /// The number that messages carry.
  readonly run: number
  /// What the learner calls it: 1 for the first run in this room.
  readonly number: number
  readonly from: RunOrigin | null
  readonly text: string
  readonly seed: number | null
  /// Of two runs of a program, one on a real robot and one beside it in the simulator, which one it is; absent for any other run.
  readonly twin?: "real" | "simulated"
  /// Of a recording: what the robot was called that drove then.
  readonly recorded?: string
  /// `null` for the run that the room shows: the state of the room is newer.
  readonly kept: ShownRun | null
}

export interface RunOrigin {
  readonly run: number
  /// The moment that it was continued from, s; `null` for a run from the start that followed the other one.
  readonly at: number | null
}

export interface RunTree {
  /// In the order in which they began: an origin stands before the runs that came from it.
  readonly nodes: readonly RunNode[]
  /// Runs that began in this room.
  readonly count: number
  /// Runs that are no longer kept.
  readonly dropped: number
  /// The run that is drawn over the shown one; `null` for none.
  readonly compared: number | null
}

export const noRuns: RunTree = {nodes: [], count: 0, dropped: 0, compared: null}

/// Most runs that are kept, and most of their frames together: 13 minutes at 50 frames a second, some 20 MB.
export const maxRuns = 20
export const maxFrames = 40_000

export const nodeOf = (tree: RunTree, run: number | null): RunNode | undefined =>
  tree.nodes.find(node => node.run === run)

/// What a run from the start follows: the shown run or, without one, the newest. With the same program it stands beside that run.
export function originOf(tree: RunTree, shown: number | null, text: string): RunOrigin | null {
  const last = nodeOf(tree, shown) ?? tree.nodes.at(-1)
  // A twin stands below its real run, where nothing else does.
  const before = last?.twin === "simulated" ? nodeOf(tree, last.from?.run ?? null) : last
  if (before === undefined) return null
  if (before.text !== text) return {run: before.run, at: null}
  return before.from === null ? null : {run: before.from.run, at: null}
}

/// Adds a run that begins. What is shown is stored with its run before.
export function beginRun(
  tree: RunTree,
  shown: ShownRun,
  begun: Pick<RunNode, "run" | "from" | "text" | "seed" | "recorded">,
): RunTree {
  const {nodes, count, ...rest} = storeShown(tree, shown)
  return bounded(
    {...rest, nodes: [...nodes, {...begun, number: count + 1, kept: null}], count: count + 1},
    begun.run,
  )
}

/// Adds a run on a real robot, and below it, compared with it, that of the same program in the simulator.
export function beginTwins(
  tree: RunTree,
  shown: ShownRun,
  begun: Pick<RunNode, "run" | "from" | "text" | "seed">,
  twin: number,
): RunTree {
  const {nodes, count, ...rest} = beginRun(tree, shown, begun)
  const {world} = shown.room
  const simulated: RunNode = {
    ...begun,
    run: twin,
    number: count,
    from: {run: begun.run, at: null},
    twin: "simulated",
    kept: {room: {...clearRoom(emptyRoom, twin), world, source: begun.text}, lines: []},
  }
  const real = nodes.map(node => (node.run === begun.run ? {...node, twin: "real" as const} : node))
  return bounded({...rest, nodes: [...real, simulated], count, compared: twin}, begun.run)
}

/// The run in the simulator beside this one on a real robot.
export const twinOf = (tree: RunTree, run: number): RunNode | undefined =>
  tree.nodes.find(node => node.twin === "simulated" && node.from?.run === run)

/// What the learner calls a run.
export function runName(
  {number, twin, recorded}: Pick<RunNode, "number" | "twin" | "recorded">,
  {
    runs,
    twin: twins,
    recordings,
  }: {
    readonly runs: Pick<Words["runs"], "run">
    readonly twin: Pick<Words["twin"], "real" | "simulated">
    readonly recordings: Pick<Words["recordings"], "run">
  },
): string {
  if (recorded !== undefined) return recordings.run(number)
  return twin === undefined ? runs.run(number) : twins[twin](number)
}

/// Stores what the room shows with its run. A run of which nothing was ever shown is removed.
export function storeShown(tree: RunTree, {room, lines}: ShownRun): RunTree {
  const nodes = tree.nodes.map(node => (node.run === room.run ? {...node, kept: {room, lines}} : node))
  return nodes
    .filter(({kept}) => kept === null || kept.room.recording.length === 0)
    .reduce<RunTree>((rest, node) => withoutRun(rest, node.run), {...tree, nodes})
}

/// Takes a run out of the store, to be shown; `null` when it is not stored. What was shown is stored, and compared with it when the run was compared before.
export function takeRun(
  tree: RunTree,
  shown: ShownRun,
  run: number,
): {readonly tree: RunTree; readonly node: RunNode & {readonly kept: ShownRun}} | null {
  const stored = storeShown(tree, shown)
  const node = nodeOf(stored, run)
  if (node === undefined || node.kept === null) return null
  const nodes = stored.nodes.map(other => (other.run === run ? {...other, kept: null} : other))
  const before = nodeOf(stored, shown.room.run)?.run ?? null
  const compared = stored.compared === run ? before : stored.compared
  return {tree: bounded({...stored, nodes, compared}, run), node: {...node, kept: node.kept}}
}

/// Compares with a stored run, or with none.
export function compareWith(tree: RunTree, run: number | null): RunTree {
  const isStored = run === null || nodeOf(tree, run)?.kept != null
  return isStored ? {...tree, compared: run} : tree
}

/// The run that is drawn over the shown one, with what was shown of it.
export function comparedRun(tree: RunTree): (RunNode & {readonly kept: ShownRun}) | null {
  const node = tree.compared === null ? undefined : nodeOf(tree, tree.compared)
  return node === undefined || node.kept === null ? null : {...node, kept: node.kept}
}

/// The tree without a run. The runs that came from it come from its origin; what they have in common with that run ends where both left it.
export function withoutRun(tree: RunTree, run: number): RunTree {
  const gone = nodeOf(tree, run)
  if (gone === undefined) return tree
  const inherited = ({at}: RunOrigin): RunOrigin | null => {
    if (gone.from === null) return null
    const since = at === null || gone.from.at === null ? null : Math.min(at, gone.from.at)
    return {run: gone.from.run, at: since}
  }
  return {
    ...tree,
    nodes: tree.nodes
      .filter(node => node !== gone)
      .map(node => (node.from?.run === run ? {...node, from: inherited(node.from)} : node)),
    compared: tree.compared === run ? null : tree.compared,
  }
}

/// The tree within its bounds: the oldest runs go that are neither shown nor compared. The newest one may go on.
function bounded(tree: RunTree, shown: number): RunTree {
  const frames = tree.nodes.reduce((sum, {kept}) => sum + (kept?.room.recording.length ?? 0), 0)
  if (tree.nodes.length <= maxRuns && frames <= maxFrames) return tree
  const oldest = tree.nodes.slice(0, -1).find(({run}) => run !== shown && run !== tree.compared)
  if (oldest === undefined) return tree
  return bounded({...withoutRun(tree, oldest.run), dropped: tree.dropped + 1}, shown)
}

/// A run in its place in the tree, as a person sees it.
export interface RunRow {
  readonly node: RunNode
  /// 1 for a run that came from no other.
  readonly level: number
  /// Its place among the runs that came from the same one, from 1, and how many these are.
  readonly place: number
  readonly siblings: number
  /// The number of the run that it was continued from, and when, s.
  readonly continued: {readonly number: number; readonly at: number} | null
  /// What was changed since the run that it came from; `null` when it came from none.
  readonly changes: readonly ProgramChange[] | null
}

/// The runs of the tree, each one above those that came from it.
export function runRows(tree: RunTree): readonly RunRow[] {
  const below = (origin: RunNode | null, level: number): readonly RunRow[] => {
    const nodes = tree.nodes.filter(node => (node.from?.run ?? null) === (origin?.run ?? null))
    return nodes.flatMap((node, i) => {
      const at = node.from?.at ?? null
      const row: RunRow = {
        node,
        level,
        place: i + 1,
        siblings: nodes.length,
        continued: origin === null || at === null ? null : {number: origin.number, at},
        changes: origin === null ? null : programChanges(origin.text, node.text),
      }
      return [row, ...below(node, level + 1)]
    })
  }
  return below(null, 1)
}
