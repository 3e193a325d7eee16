/// The world editor: tools on the left, the room in the middle, what is chosen on the right.

import type {VNode} from "preact"
import {useLayoutEffect, useRef} from "preact/hooks"
import {words} from "../words/index.ts"
import type {WorldEdit} from "../worlds/editor.ts"
import {tools} from "../worlds/making.ts"
import {startTrouble} from "../worlds/standing.ts"
import {describePart} from "./describe.ts"
import {RedoIcon, UndoIcon} from "./icons.tsx"
import {NoticeBar} from "./notice.tsx"
import {useDesk, usePage} from "./pick.ts"
import {ToolIcon} from "./toolicons.tsx"
import {PartPanel} from "./worldparts.tsx"

export function WorldEditorDialog(): VNode {
  const {store} = useDesk()
  const open = usePage(s => s.worldEditor !== null)
  const dialog = useRef<HTMLDialogElement>(null)
  useLayoutEffect(() => {
    if (open && dialog.current?.open === false) dialog.current.showModal()
    else if (!open) dialog.current?.close()
  }, [open])
  return (
    <dialog
      class="world-editor"
      ref={dialog}
      aria-label={words.world.title}
      // Escape lets go of what is chosen; it must not throw the drawing away.
      onCancel={event => {
        event.preventDefault()
        store.dispatch({kind: "world-edited", edit: {kind: "cancel"}})
      }}
    >
      {open && <Workshop />}
    </dialog>
  )
}

function Workshop(): VNode {
  const {store} = useDesk()
  const edit = (event: WorldEdit) => store.dispatch({kind: "world-edited", edit: event})
  const why = usePage(s => (s.worldEditor === null ? null : startTrouble(s.worldEditor.world)))
  return (
    <div class="workshop">
      <header class="workshop-bar">
        <h2>{words.world.title}</h2>
        <UndoPair edit={edit} />
        <span class="space" />
        <button
          type="button"
          class="plain"
          onClick={() => store.dispatch({kind: "world-editor-closed", keep: false})}
        >
          {words.world.leave}
        </button>
        <button
          type="button"
          class="run"
          disabled={why !== null}
          onClick={() => store.dispatch({kind: "world-editor-closed", keep: true})}
        >
          {words.world.done}
        </button>
      </header>
      <NoticeBar />
      <ToolBar edit={edit} />
      <Sheet />
      <PartPanel edit={edit} />
      <p class="workshop-fault" role="alert">
        {why !== null && words.world.startFaults[why]}
      </p>
    </div>
  )
}

function UndoPair({edit}: {edit: (event: WorldEdit) => void}): VNode {
  const past = usePage(s => (s.worldEditor?.past.length ?? 0) > 0)
  const future = usePage(s => (s.worldEditor?.future.length ?? 0) > 0)
  const button = (label: string, there: boolean, icon: VNode, kind: "undo" | "redo") => (
    <button
      type="button"
      class="plain icon"
      title={label}
      aria-label={label}
      disabled={!there}
      onClick={() => edit({kind})}
    >
      {icon}
    </button>
  )
  return (
    <span class="pair">
      {button(words.undo, past, <UndoIcon />, "undo")}
      {button(words.redo, future, <RedoIcon />, "redo")}
    </span>
  )
}

function ToolBar({edit}: {edit: (event: WorldEdit) => void}): VNode {
  const chosen = usePage(s => s.worldEditor?.tool ?? "choose")
  return (
    <div class="tools" role="toolbar" aria-label={words.world.tools} aria-orientation="vertical">
      {tools.map(tool => (
        <button
          type="button"
          key={tool}
          class={`tool ${tool}`}
          aria-pressed={tool === chosen}
          title={words.world.toolHints[tool]}
          onClick={() => edit({kind: "tool", tool})}
        >
          <ToolIcon tool={tool} />
          <span>{words.world.toolNames[tool]}</span>
        </button>
      ))}
    </div>
  )
}

function Sheet(): VNode {
  const desk = useDesk()
  const canvas = useRef<HTMLCanvasElement>(null)
  const tool = usePage(s => s.worldEditor?.tool ?? "choose")
  const told = usePage(s => {
    const editor = s.worldEditor
    if (editor === null) return ""
    if (editor.chosen !== null) return describePart(editor.world, editor.chosen)
    return editor.aim === null ? "" : words.world.aimAt(editor.aim)
  })
  useLayoutEffect(() => (canvas.current === null ? undefined : desk.mountWorldEditor(canvas.current)), [desk])
  return (
    <div class="sheet">
      {/* biome-ignore-start lint/a11y/noNoninteractiveTabindex: the room is drawn by keys too */}
      {/* biome-ignore-start lint/a11y/noInteractiveElementToNoninteractiveRole: an application takes keys */}
      <canvas
        ref={canvas}
        class={tool === "choose" ? "" : "drawing"}
        role="application"
        tabIndex={0}
        aria-label={words.world.sheetLabel}
        aria-describedby="sheet-told"
        data-testid="sheet"
      />
      {/* biome-ignore-end lint/a11y/noNoninteractiveTabindex: see above */}
      {/* biome-ignore-end lint/a11y/noInteractiveElementToNoninteractiveRole: see above */}
      <p id="sheet-told" class="hidden-text" aria-live="polite" data-testid="sheet-told">
        {told}
      </p>
      <p class="sheet-hint">{words.world.toolHints[tool]}</p>
    </div>
  )
}
