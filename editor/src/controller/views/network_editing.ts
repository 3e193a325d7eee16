/// Edits of the program in the diagram: what a connection would be, and the change of the text that an edit makes.

import type {
  DeclaredType,
  NetworkAction,
  NetworkEdit,
  NetworkRefusal,
  WrittenNetwork,
} from "@rosy/codegen/network-edits"
import type {Store} from "../../browser/store.ts"
import {changesBetween} from "../../program/text_changes.ts"
import type {NetworkEditing, Proposal} from "../../views/diagram/editing.ts"
import {
  actionOf,
  asksName,
  type Connection,
  type ConnectionEnd,
  connectionOf,
  hasNewMemory,
  isAboutSteps,
  joinings,
  suggestedName,
  withMemory,
} from "../../views/diagram/network/connections.ts"
import {dragOptions, stepAt} from "../../views/diagram/network/step_options.ts"
import {words} from "../../words/index.ts"
import type {DocumentEditor} from "../document/document_editor.ts"
import type {PageParts} from "../document/page_parts.ts"

/// The module of codegen that edits networks, loaded with the diagram.
export type NetworkModule = typeof import("@rosy/codegen/network-edits")

export function networkEditing(
  network: NetworkModule,
  store: Store,
  parts: PageParts,
  editor: DocumentEditor,
  show: (definition: string) => void,
): NetworkEditing {
  // Types of definitions that stay the same are remembered from one edit to the next.
  const session = new network.InferenceSession()
  const written = rememberedNetwork(workspace => network.writtenNetwork(workspace, session), store)
  const tryOut = (action: NetworkAction, declares?: DeclaredType) => {
    const {view} = store.now.document
    return parts.reader === null || view === null
      ? null
      : network.networkEdit(parts.reader, view, action, session, declares)
  }
  const sentence = (refusal: NetworkRefusal) => network.refusalSentence(refusal)
  const taken = () => new Set(store.now.document.program.definitions.map(d => d.name))
  const stepProposal = (from: ConnectionEnd, to: ConnectionEnd): Proposal => {
    const {edit} = words.diagram
    const outcomes = dragOptions(written().tasks ?? [], from, to).map(option => ({
      option,
      outcome: tryOut(option.action),
    }))
    const options = outcomes.flatMap(({option, outcome}) => (outcome?.ok ? [option] : []))
    const [first] = options
    const refusal = outcomes[0]?.outcome
    if (first === undefined)
      return {kind: "refused", why: refusal == null || refusal.ok ? edit.noStep : sentence(refusal.refusal)}
    const title = options.length === 1 ? edit.stepActions[first.as] : edit.twoSteps(nameOf(from), nameOf(to))
    return {kind: "steps", title, options}
  }
  const make = (outcome: NetworkEdit | null): string | null => {
    if (outcome === null) return words.diagram.edit.misfits["not-here"]
    if (!outcome.ok) return sentence(outcome.refusal)
    editor.changeText(changesBetween(store.now.document.program.text, outcome.text))
    editor.showBlocks()
    if (outcome.selects !== undefined) show(outcome.selects)
    return null
  }
  const nameOf = ({type}: ConnectionEnd) => stepAt(written().tasks ?? [], type)?.name ?? type
  return {
    text: () => store.now.document.program.text,
    written,
    propose(from, to) {
      editor.flush()
      if (isAboutSteps(from, to)) return stepProposal(from, to)
      const connection = connectionOf(from, to, name => ownEventsOf(written(), name))
      if (typeof connection === "string")
        return {kind: "refused", why: words.diagram.edit.misfits[connection]}
      const name = suggestedName(connection, taken(), network.readyName)
      const memories = hasNewMemory(connection) ? [...plainTypes, ...written().types] : []
      const isFitting = (type: string) =>
        tryOut(actionOf(withMemory(connection, `Memory ${type}`), name, "all"))?.ok === true
      const remembered = memories.find(isFitting) ?? memories[0] ?? ""
      const tried = withMemory(connection, `Memory ${remembered}`)
      const outcomes = joinings(tried).map(as => [as, tryOut(actionOf(tried, name, as))] as const)
      const fitting = outcomes.flatMap(([as, outcome]) => (outcome?.ok ? [as] : []))
      const [first] = outcomes
      const refusal = first?.[1]
      if (fitting.length === 0)
        return {
          kind: "refused",
          why:
            refusal == null || refusal.ok
              ? words.diagram.edit.misfits["not-here"]
              : sentence(refusal.refusal),
        }
      return {
        kind: "offered",
        connection,
        title: titleOf(connection),
        asks: asksName(connection),
        name,
        joinings: fitting,
        // The first is chosen at first.
        memories: memories.length === 0 ? [] : [...new Set([remembered, ...memories])],
      }
    },
    edit(action, declares) {
      editor.flush()
      return make(tryOut(action, declares))
    },
    definitions() {
      const {view} = store.now.document
      return view === null ? [] : network.definitionTexts(view)
    },
    define(name, text) {
      editor.flush()
      const {view} = store.now.document
      return make(
        parts.reader === null || view === null
          ? null
          : network.definitionEdit(parts.reader, view, name, text),
      )
    },
  }
}

/// The network of the page's blocks, made again only when they are others.
function rememberedNetwork(
  make: (workspace: Store["now"]["document"]["workspace"]) => WrittenNetwork,
  store: Store,
): () => WrittenNetwork {
  let known: {readonly workspace: unknown; readonly written: WrittenNetwork} | null = null
  return () => {
    const {workspace} = store.now.document
    if (known?.workspace !== workspace) known = {workspace, written: make(workspace)}
    return known.written
  }
}

/// What a pupil's first programs remember, and where the robot was.
const plainTypes = ["Bool", "Int", "Double", "Position", "Orientation"]

function titleOf(connection: Connection): string {
  const say = words.diagram.edit
  switch (connection.kind) {
    case "new-function":
      return say.newFunction(connection.sensor === "()" ? null : connection.sensor, connection.actuator)
    case "input":
      return say.takes(connection.function, connection.type)
    case "output":
      return say.sends(connection.function, connection.type)
    default:
      return connection.event === null
        ? say.newEvent(connection.from, connection.to)
        : say.takes(connection.to, connection.event)
  }
}

/// The program's own events among what a function sends.
function ownEventsOf({functions}: WrittenNetwork, name: string): readonly string[] {
  type Shape = WrittenNetwork["functions"][number]["output"]
  const inside = (shape: Shape): readonly string[] => {
    if (shape.kind === "type") return shape.own ? [shape.written] : []
    return shape.kind === "all" || shape.kind === "either" ? shape.of.flatMap(inside) : inside(shape.of)
  }
  return functions.filter(f => f.name === name).flatMap(f => inside(f.output))
}
