/// Mounts of the views that are not Preact components: each function creates a view in its element and connects it to the document and the store.

import * as codegen from "@rosy/codegen"
import type {NumberDragListener} from "../../browser/number_grip.ts"
import {openExplanations} from "../../browser/remote_resources.ts"
import type {Store} from "../../browser/store.ts"
import {type BlockId, signatureFix} from "../../program/program.ts"
import {mayPreview} from "../../reducers/preview_requests.ts"
import {lookedBackFor, motionQuestion, type Question} from "../../state/messages/why_state.ts"
import type {ProgramStore} from "../../storage/program_store.ts"
import {caseQuestion} from "../../values/untaken_case.ts"
import {definitionQuestion} from "../../values/value_labels.ts"
import {openBlocks} from "../../views/blocks/index.ts"
import type {SharedClipboard} from "../../views/blocks/interaction/clipboard.ts"
import {openWorldEditor} from "../../views/room/editor/world_editor_view.ts"
import type {QuestionTarget} from "../../views/room/question_targets.ts"
import {openRoom} from "../../views/room/room_view.ts"
import {openHaskellPane} from "../../views/source/haskell_pane.ts"
import {words} from "../../words/index.ts"
import {offerRepair} from "../document/character_repair.ts"
import type {Tone} from "../document/colour_scheme.ts"
import {type Completions, snippets} from "../document/completion_requests.ts"
import type {DocumentCommands} from "../document/document_commands.ts"
import {longestProgram} from "../document/document_conversion.ts"
import type {DocumentEditor} from "../document/document_editor.ts"
import type {PageParts} from "../document/page_parts.ts"
import type {BackpackCommands} from "../programs/backpack.ts"

export interface MountContext {
  readonly store: Store
  readonly parts: PageParts
  readonly editor: DocumentEditor
  readonly commands: DocumentCommands
  readonly numbers: NumberDragListener
}

export function mountBlocks(
  host: HTMLElement,
  {store, parts, editor, commands, numbers}: MountContext,
  programStore: ProgramStore,
  clipboard: SharedClipboard,
  backpack: BackpackCommands,
  tone: Tone,
): void {
  parts.blocksHost = host
  host.inert = parts.reader === null
  // The blocks are brought up to date before the learner opens an editor in them: loading blocks would close it.
  host.addEventListener("pointerenter", () => {
    editor.flush()
    editor.showBlocks()
  })
  const blocks = openBlocks(host, {
    language: codegen,
    tone,
    rightToLeft: document.documentElement.dir === "rtl",
    level: programStore.level() ?? "reactions",
    onLevel: level => programStore.setLevel(level),
    clipboard,
    backpack,
    outside: {
      area: () => parts.source?.dropArea() ?? null,
      over: commands.previewDrop,
      left: () => parts.source?.previewDrop(null),
      dropped: commands.drop,
    },
    numbers,
    history: {
      undo: commands.undo,
      redo: commands.redo,
      canUndo: () => store.now.history.past.length > 0,
      canRedo: () => store.now.history.future.length > 0,
    },
    questions: {
      canAsk: () => store.now.room.run !== null,
      why(name) {
        const time = store.now.room.lookedAt ?? store.now.room.frame?.time ?? null
        const question = {kind: "run", function: name, time} as const
        store.dispatch({kind: "why", event: {kind: "asked", question}})
      },
      whyNot(name) {
        const until = store.now.room.lookedAt ?? store.now.room.frame?.time ?? 0
        const since = Math.max(0, until - lookedBackFor)
        const question = {kind: "not", function: name, command: "", since, until} as const
        store.dispatch({kind: "why", event: {kind: "asked", question}})
      },
      hasCase: block => caseQuestion(store.now, block) !== null,
      whyNotCase(block) {
        const question = caseQuestion(store.now, block)
        if (question !== null) store.dispatch({kind: "why", event: {kind: "asked", question}})
      },
      hasValue: block => definitionQuestion(store.now, block) !== null,
      whyValue: block => askOfDefinition(store, block),
    },
  })
  parts.blocks = blocks
  blocks.onChange(({workspace, inference}) => editor.blocksEdited(workspace, inference))
  blocks.onSelect(block => store.dispatch({kind: "selected", block: block ?? null, in: "blocks"}))
}

/// Asks why the values at a definition are as they are, if there are any.
function askOfDefinition(store: Store, block: BlockId): void {
  const question = definitionQuestion(store.now, block)
  if (question !== null) store.dispatch({kind: "why", event: {kind: "asked", question}})
}

/// `edited` is called with each edit, before the document has it.
export function mountSource(
  host: HTMLElement,
  {store, parts, editor, commands, numbers}: MountContext,
  completions: Completions,
  edited: () => void,
): void {
  parts.source = openHaskellPane(host, {
    label: words.haskellPane,
    description: words.haskellKeys,
    completer: {fitting: completions.fitting, snippets, fromToolbox: words.fromToolbox},
    renamer: {rename: commands.rename, words: {label: words.newName, rename: words.rename}},
    phrases: words.editor,
    longest: longestProgram,
    tooLong: () => store.dispatch({kind: "notice", notice: {kind: "too-large", name: words.pastedText}}),
    pasted: (text, parts) => offerRepair(store, words.pastedText, text, parts),
    format: commands.format,
    explainer: {about: openExplanations().about, more: words.readMore},
    cursorMoved: editor.cursorMoved,
    valueClicked: block => askOfDefinition(store, block),
    asked(offset) {
      const {definitions} = store.now.document.program
      const around = definitions.find(({start, end}) => start <= offset && offset <= end)
      if (around !== undefined) askOfDefinition(store, around.block)
    },
    mend: commands.applyFix,
    numbers: {...numbers, hint: words.preview.dragNumber},
    fixHere(offset) {
      const {document, declared} = store.now
      return signatureFix(document.program, declared, offset, words.writeType)
    },
    edited(text, changes, isOwn) {
      // A preview need not wait for the document.
      if (mayPreview(store.now)) store.dispatch({kind: "text-typed", text})
      editor.typing.typed(text, changes, isOwn)
      edited()
    },
  })
}

/// The result removes the editor.
export function mountWorldEditor(canvas: HTMLCanvasElement, {store, parts}: MountContext): () => void {
  const view = openWorldEditor(canvas, {
    changed: () => store.redraw(),
    edited: edit => store.dispatch({kind: "world-edited", edit}),
  })
  parts.worldEditor = view
  store.redraw()
  return () => {
    view.dispose()
    parts.worldEditor = null
  }
}

export function mountRoom(canvas: HTMLCanvasElement, {store, parts}: MountContext): void {
  parts.roomCanvas = canvas
  parts.room = openRoom(canvas, {
    changed: () => store.redraw(),
    placed: teleport => store.dispatch({kind: "hand", hand: {teleport}}),
    pushed: (thing, pose) => store.dispatch({kind: "hand", hand: {move: {thing, ...pose}}}),
    holds: thing => store.dispatch({kind: "held", thing}),
    companionPlaced: (companion, place, isDropped) =>
      store.dispatch({kind: "companion-placed", companion, place, isDropped}),
    follows: follows => store.dispatch({kind: "follows", follows}),
    read: () => store.dispatch({kind: "why", event: {kind: "closed"}}),
    asked(about) {
      const {room} = store.now
      const time = room.lookedAt ?? room.frame?.time ?? null
      if (room.run === null || time === null) return
      store.dispatch({kind: "why", event: {kind: "asked", question: questionAbout(about, time)}})
    },
  })
}

/// `time` is the displayed moment, s.
function questionAbout(about: QuestionTarget, time: number): Question {
  switch (about.kind) {
    case "robot":
      return motionQuestion(time)
    case "place":
      return {kind: "position", time: about.time ?? time}
    case "led":
      return {kind: "command", command: about.command, value: "", time}
    case "speech":
      return {kind: "command", command: "Say", value: about.text, time: about.time}
  }
}
