/// The text of a definition in the diagram: equations of a function, and what wires do not show, such as types and helpers.

import type {JSX, VNode} from "preact"
import {useLayoutEffect, useRef, useState} from "preact/hooks"
import type {PageState} from "../../state/page_state.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import type {Point} from "../../views/diagram/layout/geometry.ts"
import {words} from "../../words/index.ts"
import {usePlaceInWindow} from "./place_in_window.ts"

/// A definition to write, at a place of the window; `null` is a new one.
export interface AskedDefinition {
  readonly name: string | null
  readonly at: Point
}

/// Whether the diagram is all that is seen of the program, so that equations are written nowhere else.
export function isOnlyView({size, arrangement: {hidden}}: Pick<PageState, "size" | "arrangement">): boolean {
  return size !== "wide" || (hidden.includes("blocks") && hidden.includes("haskell"))
}

/// The place below a button, for what it opens.
export function below(button: Element): Point {
  const {left, bottom} = button.getBoundingClientRect()
  return {x: left, y: bottom}
}

export function DefinitionEditor({asked, close}: {asked: AskedDefinition; close: () => void}): VNode {
  const controller = useController()
  const editing = controller.diagram.editing()
  const {name, at} = asked
  const [text, setText] = useState(() => editing?.definitions().find(d => d.name === name)?.text ?? "")
  const [why, setWhy] = useState<string | null>(null)
  const form = useRef<HTMLFormElement>(null)
  const field = useRef<HTMLTextAreaElement>(null)
  usePlaceInWindow(form, at)
  // Before anything can be typed into it.
  useLayoutEffect(() => {
    const place = firstEmptyPlace(text)
    field.current?.focus()
    if (place !== null) field.current?.setSelectionRange(place, place + 1)
  }, [])
  const {edit} = words.diagram
  const write = () => {
    const refused = editing?.define(name, text) ?? null
    setWhy(refused)
    if (refused === null) close()
  }
  return (
    <form
      class="diagram-ask definition"
      // Enter is a new line; the keys of Run submit it.
      data-keys="multiline"
      ref={form}
      aria-label={name === null ? edit.newDefinition : edit.definitionOf(name)}
      onSubmit={event => {
        event.preventDefault()
        write()
      }}
      onKeyDown={event => {
        if (event.key !== "Escape") return
        event.preventDefault()
        event.stopPropagation()
        close()
      }}
    >
      <label class="field">
        <span>{name === null ? edit.newDefinition : edit.definitionOf(name)}</span>
        <textarea
          ref={field}
          dir="ltr"
          rows={Math.min(12, Math.max(3, text.split("\n").length + 1))}
          value={text}
          placeholder={name === null ? "data Mode = Calm | Alarmed" : ""}
          spellcheck={false}
          autocomplete="off"
          autocapitalize="off"
          onInput={event => setText(event.currentTarget.value)}
          onKeyDown={indent}
        />
      </label>
      {why !== null && (
        <p class="refused" role="alert">
          {why}
        </p>
      )}
      <div class="pair">
        <button type="submit" class="plain small" title={edit.writeHint}>
          {edit.write}
        </button>
        <button type="button" class="plain small" onClick={close}>
          {edit.cancel}
        </button>
      </div>
    </form>
  )
}

/// A new line begins below the beginning of the one before.
function indent(event: JSX.TargetedKeyboardEvent<HTMLTextAreaElement>): void {
  if (event.key !== "Enter" || event.ctrlKey || event.metaKey || event.isComposing) return
  const {value, selectionStart} = event.currentTarget
  const line = value.slice(value.lastIndexOf("\n", selectionStart - 1) + 1, selectionStart)
  const space = /^ */.exec(line)?.[0] ?? ""
  // The browser's own insertion keeps its undo.
  if (space !== "" && document.execCommand("insertText", false, `\n${space}`)) event.preventDefault()
}

/// The first empty place of an answer: what is left of `=` in its line are patterns.
export function firstEmptyPlace(text: string): number | null {
  const found = /=(?:[^\n]*?[^\n\p{L}\p{N}_'])?\s*(?<![\p{L}\p{N}_'])_(?![\p{L}\p{N}_'])/u.exec(text)
  return found === null ? null : found.index + found[0].length - 1
}

/// The definitions that are no nodes, such as types and helpers, and a place for a new one.
export function OtherDefinitions({open}: {open: (asked: AskedDefinition) => void}): VNode | null {
  const controller = useController()
  usePageState(s => s.document.workspace)
  usePageState(s => s.diagram.drawings)
  const editing = controller.diagram.editing()
  if (editing === null) return null
  const functions = new Set(editing.written().functions.map(f => f.name))
  const others = editing.definitions().filter(({name}) => !functions.has(name))
  const {edit} = words.diagram
  return (
    <fieldset class="diagram-beside" aria-label={edit.otherDefinitions}>
      <span>{edit.otherDefinitions}</span>
      {others.map(({name}) => (
        <button
          key={name}
          type="button"
          class="plain small"
          onClick={event => open({name, at: below(event.currentTarget)})}
        >
          {name}
        </button>
      ))}
      <button
        type="button"
        class="plain small"
        onClick={event => open({name: null, at: below(event.currentTarget)})}
      >
        {edit.newDefinition}
      </button>
    </fieldset>
  )
}
