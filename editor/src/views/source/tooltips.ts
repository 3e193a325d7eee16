/// Tooltips of the Haskell pane: type and documentation of the word under the pointer, and the signature of the function call at the cursor.

import {type EditorState, type Extension, StateField} from "@codemirror/state"
import {hoverTooltip, showTooltip, type Tooltip} from "@codemirror/view"
import {callAt, inputsOf, type Token, tokens} from "@rosy/codegen"
import type {Explanation} from "../../browser/remote_resources.ts"
import {offsetOf} from "../../program/program.ts"
import {compilerInfo, namesNamed, typeOfName} from "./completion.ts"

export interface Documentation {
  about(name: string): Promise<Explanation | null>
  /// The label of the link to all of an explanation.
  readonly more: string
}

/// The type of the innermost piece of the text around `pos` that the compiler knows, and that piece.
export function typeAt(state: EditorState, pos: number): {start: number; end: number; type: string} | null {
  const {types} = state.field(compilerInfo)
  const text = state.doc.toString()
  if (types.text !== text) return null
  const {number, from} = state.doc.lineAt(pos)
  let best: {start: number; end: number; type: string} | null = null
  for (const [line = 0, column = 0, endLine = 0, endColumn = 0, n = 0] of types.at) {
    if (line > number || endLine < number || (line === endLine && column > pos - from + 1)) continue
    const start = offsetOf(text, {line, column})
    const end = offsetOf(text, {line: endLine, column: endColumn})
    const type = types.names[n]
    if (start <= pos && pos < end && type !== undefined) best = {start, end, type}
  }
  return best
}

/// Longer pieces are not said again.
const longest = 60

function linesAbout(state: EditorState, token: Token, pos: number): readonly string[] {
  const word = state.doc.sliceString(token.start, token.end)
  const place = typeAt(state, pos)
  const piece = place === null ? "" : state.doc.sliceString(place.start, place.end)
  const here =
    place === null || piece.length > longest || piece.includes("\n") ? null : `${piece} :: ${place.type}`
  const own = state.field(compilerInfo).declared.find(d => d.name === word)
  const general =
    own !== undefined
      ? [`${own.name} :: ${own.type}`]
      : namesNamed(word).map(n =>
          n.kind === "type"
            ? `data ${n.name}${n.type === "" ? "" : ` = ${n.type}`}`
            : `${n.name} :: ${n.type}`,
        )
  return [...new Set([...(here === null ? [] : [here]), ...general])]
}

function row(className: string, text: string): HTMLElement {
  const element = document.createElement("div")
  element.className = className
  element.textContent = text
  return element
}

function hover(explainer: Documentation): Extension {
  return hoverTooltip(async (view, pos): Promise<Tooltip | null> => {
    const token = tokens(view.state.doc.toString()).find(t => t.start <= pos && pos < t.end)
    if (token === undefined || token.kind === "comment" || token.kind === "pragma") return null
    const lines = linesAbout(view.state, token, pos)
    const word = view.state.doc.sliceString(token.start, token.end)
    const own = view.state.field(compilerInfo).declared.some(d => d.name === word)
    const named = token.kind === "name" || token.kind === "type"
    const more = named && !own && namesNamed(word).length > 0 ? await explainer.about(word) : null
    if (lines.length === 0 && more === null) return null
    return {
      pos: token.start,
      end: token.end,
      above: true,
      create() {
        const dom = document.createElement("div")
        dom.className = "hs-explained"
        for (const line of lines) dom.append(row("hs-type", line))
        if (more !== null && more.words !== "") dom.append(row("hs-words", more.words))
        if (more !== null) {
          const link = document.createElement("a")
          link.href = more.address
          link.target = "_blank"
          link.rel = "noopener"
          link.textContent = explainer.more
          dom.append(link)
        }
        return {dom}
      },
    }
  })
}

/// Lines above the cursor in which the definition that it is in must begin.
const furthest = 80

function callTooltip(state: EditorState): Tooltip | null {
  const {head, empty} = state.selection.main
  if (!empty) return null
  let line = state.doc.lineAt(head)
  for (let i = 0; i < furthest && line.number > 1 && /^(?:\s|$)/.test(line.text); i += 1)
    line = state.doc.line(line.number - 1)
  const call = callAt(state.doc.sliceString(line.from, head))
  const type = call === null ? undefined : typeOfName(state.field(compilerInfo).declared, call.name)
  if (call === null || type === undefined) return null
  const parts = inputsOf(type)
  if (call.argument >= parts.length - 1) return null
  return {
    pos: head,
    above: true,
    create() {
      const dom = document.createElement("div")
      dom.className = "hs-explained hs-call"
      dom.append(`${call.name} :: `)
      parts.forEach((part, i) => {
        if (i > 0) dom.append(" -> ")
        const shown = document.createElement(i === call.argument ? "b" : "span")
        shown.textContent = part
        dom.append(shown)
      })
      return {dom}
    },
  }
}

/// Shown during typing; not for a cursor that only moves through the text.
const call = StateField.define<Tooltip | null>({
  create: () => null,
  update(value, transaction) {
    if (transaction.docChanged)
      return transaction.isUserEvent("input") ? callTooltip(transaction.state) : null
    return transaction.selection === undefined ? value : null
  },
  provide: field => showTooltip.from(field),
})

export const tooltips = (explainer: Documentation): Extension => [hover(explainer), call]
