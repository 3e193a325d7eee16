/// The diagram in the page: loads it when it is shown for the first time, gives it programs and frames, and leads from a node to its block and line.

import {download, downloadBlob, fileName} from "../../browser/local_files.ts"
import type {Store} from "../../browser/store.ts"
import {innermostBlock, offsetOf, selectedDefinition, textRangeOf} from "../../program/program.ts"
import type {Extent} from "../../program/program_graph.ts"
import {viewOf} from "../../state/arrangement.ts"
import type {Explanation} from "../../state/messages/why_state.ts"
import {awaitsProgram, type PageState} from "../../state/page_state.ts"
import {framesBetween} from "../../state/runs/recording.ts"
import {shownFrame} from "../../state/runs/room_state.ts"
import {conflictsOf} from "../../state/visible_findings.ts"
import type {AppController} from "../../ui/app_context.ts"
import {lastOf} from "../../values/last_values.ts"
import {nodeQuestions} from "../../values/node_questions.ts"
import type {NetworkEditing} from "../../views/diagram/editing.ts"
import type * as DiagramModule from "../../views/diagram/index.ts"
import type {DiagramNode, DiagramView} from "../../views/diagram/index.ts"
import {causalPath, noPath} from "../../views/diagram/network/causal_path.ts"
import {stepAround} from "../../views/diagram/network/step_options.ts"
import {measures, words} from "../../words/index.ts"
import type {DocumentEditor} from "../document/document_editor.ts"
import type {PageParts} from "../document/page_parts.ts"
import {networkEditing} from "./network_editing.ts"

export interface DiagramMount {
  mount(host: HTMLElement): void
  readonly commands: AppController["diagram"]
  /// Once per frame.
  update(state: PageState, now: number): void
}

/// What the page loads with the diagram.
interface LoadedDiagram {
  readonly view: DiagramView
  readonly editing: NetworkEditing
  readonly parts: Pick<typeof DiagramModule, "pendingParts" | "openedTasks" | "withWrittenTasks">
}

export function openDiagramMount(store: Store, parts: PageParts, editor: DocumentEditor): DiagramMount {
  let host: HTMLElement | null = null
  let loaded: LoadedDiagram | null = null
  let isLoading = false
  let places: PageState["diagram"]["places"] = {}
  let explained: Explanation | null = null
  const followProgram = programFollower()
  const followRun = runFollower(store)

  const load = async (into: HTMLElement) => {
    isLoading = true
    try {
      loaded = await loadDiagram(into, store, parts, editor)
      store.redraw()
    } catch {
      store.dispatch({kind: "diagram", outcome: "failed"})
    }
  }

  return {
    mount(into) {
      host = into
      // While a node may be asked for its last value, the page follows the firings.
      const points = (isPointedAt: boolean) => store.dispatch({kind: "diagram-pointed", isPointedAt})
      into.addEventListener("pointerenter", () => points(true))
      into.addEventListener("pointerleave", () => points(false))
      into.addEventListener("focusin", () => points(true))
      into.addEventListener("focusout", () => points(false))
    },
    update(state, now) {
      if (host === null || !isShown(state)) return
      if (loaded === null) {
        if (!isLoading) void load(host)
        return
      }
      const {view} = loaded
      if (places !== state.diagram.places) {
        places = state.diagram.places
        view.place(places)
      }
      followProgram(state, loaded)
      const answer = state.why.open?.answer ?? null
      if (answer !== explained) {
        explained = answer
        view.explain(answer === null ? noPath : causalPath(answer))
      }
      const {program} = state.document
      const {tasks} = loaded.editing.written()
      const step = stepAround(tasks ?? [], state.selected, block => textRangeOf(program.spans, block))
      view.select(selectedDefinition(program, state.selected), step?.block ?? null)
      followRun(state, view, now)
    },
    commands: {
      editing: () => loaded?.editing ?? null,
      tidy() {
        if (Object.keys(places).length > 0) store.dispatch({kind: "nodes-moved", places: {}})
        loaded?.view.tidy()
      },
      setMoving: on => loaded?.view.setMoving(on),
      list: path => loaded?.view.list(path) ?? [],
      choose: id => loaded?.view.chooseById(id),
      saveSvg() {
        void loaded?.view.svgFile().then(file => download(nameOf(store, "svg"), file, "image/svg+xml"))
      },
      savePng() {
        void loaded?.view.pngFile().then(file => file !== null && downloadBlob(nameOf(store, "png"), file))
      },
    },
  }
}

async function loadDiagram(
  host: HTMLElement,
  store: Store,
  parts: PageParts,
  editor: DocumentEditor,
): Promise<LoadedDiagram> {
  const [diagram, network] = await Promise.all([
    import("../../views/diagram/index.ts"),
    import("@rosy/codegen/network-edits"),
  ])
  const editing = networkEditing(network, store, parts, editor, name => chooseDefinition(store, parts, name))
  const view = diagram.openDiagram(host, {
    words: words.diagram,
    chosen: node => choose(store, parts, node),
    valueClicked(node) {
      const {room} = store.now
      const time = room.lookedAt ?? room.frame?.time ?? null
      const question = time === null || room.run === null ? undefined : nodeQuestions(node, time)[0]
      if (question !== undefined) store.dispatch({kind: "why", event: {kind: "asked", question}})
    },
    moved: places => store.dispatch({kind: "nodes-moved", places}),
    lastOf: node => lastOf(store.now.room, node, words.why, measures),
    typeOf: node => store.now.declared.find(d => d.name === node.key)?.type ?? null,
    drawn: (outcome, nodes) => store.dispatch({kind: "diagram", outcome, nodes}),
  })
  return {view, editing, parts: diagram}
}

/// Shows the parts of the program when they differ from those that are shown.
function programFollower(): (state: PageState, diagram: LoadedDiagram) => void {
  let shown = ""
  let shownOf: readonly unknown[] = []
  let opened: ReturnType<typeof DiagramModule.openedTasks> = new Map()
  return (state, {view, editing, parts}) => {
    const {network, document, findings} = state
    // A program with an empty place is not reported; what its text says of it is shown all the same.
    const isReported =
      network !== null && (network.text === document.program.text || document.dimmed.length > 0)
    const of = [isReported ? network : document.workspace, document.findings, findings.run]
    if (of.every((one, i) => one === shownOf[i]) || awaitsProgram(state)) return
    shownOf = of
    const defined = new Set(document.program.definitions.map(d => d.name))
    const {program} = document
    if (isReported && network.text === program.text)
      opened = parts.openedTasks(network.parts, at =>
        innermostBlock(program.spans, rangeAt(program.text, at)),
      )
    const written = editing.written()
    const functions = isReported ? network.parts : parts.pendingParts(network?.parts ?? [], written, defined)
    const now = parts.withWrittenTasks(functions, written.tasks, opened, block => {
      const range = textRangeOf(program.spans, block)
      return range === null ? "" : program.text.slice(range.start, range.end)
    })
    const commands = new Set(conflictsOf(state).flatMap(f => f.conflict?.command ?? []))
    const conflicts = written.hasSimulate ? commands : null
    const content = JSON.stringify([now, conflicts === null ? null : [...conflicts]])
    if (content === shown) return
    shown = content
    view.show(now, network?.text ?? document.program.text, conflicts)
  }
}

/// Shows the frames of the run that were not shown yet, or the one that is looked back at.
function runFollower(store: Store): (state: PageState, diagram: DiagramView, now: number) => void {
  let run: number | null = null
  let lookedAt: number | null = null
  /// Seconds of the run up to which frames have been seen.
  let seenTo = Number.NEGATIVE_INFINITY
  return ({room, run: {kind}}, diagram, now) => {
    if (room.run !== run || room.lookedAt !== lookedAt) {
      diagram.clear()
      run = room.run
      lookedAt = room.lookedAt
      // After looking back only what is new lights up; values come with the first frame.
      seenTo =
        lookedAt === null && room.frame !== null && room.frame.time > 1
          ? room.frame.time - 1
          : Number.NEGATIVE_INFINITY
    }
    if (lookedAt !== null) {
      diagram.at(shownFrame(room), now)
      return
    }
    const frames = [...framesBetween(room.recording, seenTo, Number.POSITIVE_INFINITY)].filter(
      f => f.time > seenTo,
    )
    seenTo = frames.at(-1)?.time ?? seenTo
    if (kind === "ended") diagram.rest()
    if (diagram.live(frames, now)) store.redraw()
  }
}

const rangeAt = (text: string, at: Extent) => ({
  start: offsetOf(text, at),
  end: offsetOf(text, {line: at.endLine, column: at.endColumn}),
})

const nameOf = (store: Store, extension: string) =>
  fileName(`${store.now.name} ${words.diagram.file}`.trim(), extension)

/// Whether the diagram is to be seen.
function isShown({size, region, arrangement}: PageState): boolean {
  if (size === "phone") return region === "diagram"
  return size === "tablet" ? viewOf(arrangement) === "diagram" : !arrangement.hidden.includes("diagram")
}

/// Selects a definition in blocks and text.
function chooseDefinition(store: Store, parts: PageParts, name: string): void {
  const definition = store.now.document.program.definitions.find(d => d.name === name)
  if (definition === undefined) return
  parts.source?.reveal({start: definition.start, end: definition.end})
  store.dispatch({kind: "selected", block: definition.block, in: "blocks"})
  if (!store.now.arrangement.hidden.includes("blocks")) parts.blocks?.select(definition.block)
}

/// Selects the block of a node and shows its text.
function choose(store: Store, parts: PageParts, node: DiagramNode): void {
  store.dispatch({kind: "node-chosen", node: {kind: node.kind, key: node.key}})
  const {program} = store.now.document
  const definition = program.definitions.find(d => d.name === node.key)
  const {at} = node
  const isCurrent = store.now.network?.text === program.text
  const place = at === null || !isCurrent ? null : rangeAt(program.text, at)
  // A step is where it stands, not where what it calls is defined. One that is all of its task may have no text of its own.
  const range = node.block === null ? (definition ?? place) : textRangeOf(program.spans, node.block)
  if (range !== null) parts.source?.reveal({start: range.start, end: range.end})
  const block =
    node.block ?? definition?.block ?? (range === null ? null : innermostBlock(program.spans, range))
  if (block === null) return
  store.dispatch({kind: "selected", block, in: "blocks"})
  if (!store.now.arrangement.hidden.includes("blocks")) parts.blocks?.select(block)
}
