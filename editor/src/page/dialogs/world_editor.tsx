/// World editor dialog: tools, canvas, and the properties of the selection; with the tools' icons.

import type {VNode} from "preact"
import {useLayoutEffect, useRef} from "preact/hooks"
import {useController, usePageState} from "../../ui/app_context.ts"
import {describePart} from "../../ui/descriptions.ts"
import {RedoIcon, UndoIcon} from "../../ui/icons.tsx"
import {words} from "../../words/index.ts"
import {type Tool, tools} from "../../worlds/drawing_tools.ts"
import type {WorldEdit} from "../../worlds/editor_value.ts"
import {startFaultKind} from "../../worlds/start_validation.ts"
import {partLimits} from "../../worlds/world_parts.ts"
import {NoticeBar} from "../bars/notice_bar.tsx"
import {PartPanel} from "./part_panel.tsx"

export function WorldEditorDialog(): VNode {
  const {store} = useController()
  const open = usePageState(s => s.worldEditor !== null)
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
  const {store} = useController()
  const edit = (event: WorldEdit) => store.dispatch({kind: "world-edited", edit: event})
  const why = usePageState(s => (s.worldEditor === null ? null : startFaultKind(s.worldEditor.world)))
  const refused = usePageState(s => s.worldEditor?.refused ?? null)
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
        {why !== null
          ? words.world.startFaults[why]
          : refused !== null && words.world.refused[refused](partLimits[refused])}
      </p>
    </div>
  )
}

function UndoPair({edit}: {edit: (event: WorldEdit) => void}): VNode {
  const past = usePageState(s => (s.worldEditor?.past.length ?? 0) > 0)
  const future = usePageState(s => (s.worldEditor?.future.length ?? 0) > 0)
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
  const chosen = usePageState(s => s.worldEditor?.tool ?? "choose")
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
  const controller = useController()
  const canvas = useRef<HTMLCanvasElement>(null)
  const tool = usePageState(s => s.worldEditor?.tool ?? "choose")
  const told = usePageState(s => {
    const editor = s.worldEditor
    if (editor === null) return ""
    if (editor.chosen !== null) return describePart(editor.world, editor.chosen)
    return editor.aim === null ? "" : words.world.aimAt(editor.aim)
  })
  useLayoutEffect(
    () => (canvas.current === null ? undefined : controller.mountWorldEditor(canvas.current)),
    [controller],
  )
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

const stroke = {fill: "none", stroke: "currentColor", "stroke-width": 1.8, "stroke-linecap": "round"} as const
const dashed = {...stroke, "stroke-width": 1.6, "stroke-dasharray": "2.6 2.4"} as const

const pictures: Readonly<Record<Tool, VNode>> = {
  choose: (
    <path
      d="M5 3.2 15.5 9l-4.6 1.4-2 4.4z"
      fill="currentColor"
      stroke="currentColor"
      stroke-linejoin="round"
    />
  ),
  wall: <path d="M3.5 14.5 14.5 3.5" {...stroke} stroke-width={3.2} />,
  box: <rect x="3.5" y="4.5" width="11" height="9" rx="1.2" fill="currentColor" />,
  crate: (
    <>
      <rect x="3.5" y="4.5" width="11" height="9" rx="1.2" {...stroke} />
      <path d="M6.5 9h5M9.6 7.2 11.5 9l-1.9 1.8" {...stroke} stroke-width={1.4} />
    </>
  ),
  round: <circle cx="9" cy="9" r="5" fill="currentColor" />,
  drum: (
    <>
      <circle cx="9" cy="9" r="5.6" {...stroke} />
      <path d="M6.8 9h4.4M9.6 7.4 11.2 9l-1.6 1.6" {...stroke} stroke-width={1.4} />
    </>
  ),
  solid: <path d="M3 3h6v6H3zM9 9h6v6H9zM3 9.9h5.1V15H3z" fill="currentColor" />,
  hole: (
    <>
      <rect x="3" y="3" width="12" height="12" rx="1" {...stroke} stroke-width={1.2} />
      <rect x="6" y="6" width="6" height="6" fill="currentColor" />
    </>
  ),
  floor: (
    <>
      <rect x="3" y="3" width="12" height="12" rx="1" {...stroke} stroke-width={1.4} />
      <path d="M9 3v12M3 9h12" {...stroke} stroke-width={1} />
    </>
  ),
  line: <path d="M3 13c2-8 5-8 6-4s3.5 4 6-4" {...stroke} stroke-width={2.6} />,
  reach: (
    <>
      <circle cx="9" cy="9" r="5.8" {...dashed} />
      <circle cx="9" cy="9" r="1.6" fill="currentColor" />
    </>
  ),
  touch: (
    <>
      <circle cx="9" cy="9" r="5.8" {...dashed} />
      <path d="M6 9h4.6M8.8 7 10.8 9l-2 2" {...stroke} stroke-width={1.5} />
      <path d="M12 6.6v4.8" {...stroke} />
    </>
  ),
  avoid: (
    <>
      <circle cx="9" cy="9" r="5.8" {...dashed} />
      <path d="m5.2 5.2 7.6 7.6" {...stroke} />
    </>
  ),
  visit: (
    <>
      <circle cx="5" cy="12.6" r="2.2" {...stroke} stroke-width={1.4} />
      <circle cx="12.6" cy="11" r="2.2" {...stroke} stroke-width={1.4} />
      <circle cx="8.4" cy="5" r="2.2" {...stroke} stroke-width={1.4} />
    </>
  ),
  lap: <path d="M4 14V3.5h9.5l-2 2.8 2 2.8H4" {...stroke} stroke-width={1.6} stroke-linejoin="round" />,
  draw: <path d="M3 13c2-8 5-8 6-4s3.5 4 6-4" {...dashed} />,
}

export function ToolIcon({tool}: {tool: Tool}): VNode {
  return (
    <svg viewBox="0 0 18 18" width={18} height={18} aria-hidden="true">
      {pictures[tool]}
    </svg>
  )
}
