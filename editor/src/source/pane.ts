/// The Haskell pane: CodeMirror, in step with the blocks. It is read here and edited there; the blocks' text is
/// set with as few changes as it takes, so that the cursor and the scroll position stay.

import {standardKeymap} from "@codemirror/commands"
import {bracketMatching} from "@codemirror/language"
import {type Diagnostic, lintGutter, setDiagnostics} from "@codemirror/lint"
import {highlightSelectionMatches, search, searchKeymap} from "@codemirror/search"
import {EditorState} from "@codemirror/state"
import {drawSelection, EditorView, keymap} from "@codemirror/view"
import type {Finding, Program} from "../state/program.ts"
import {colours, programShown} from "./colours.ts"
import {difference} from "./difference.ts"
import {marks, type Range, setGlowing, setLinked} from "./marks.ts"

export interface SourcePane {
  setProgram(program: Program): void
  /// Marks the text of the block under the cursor; scrolls to it unless the cursor is in the text itself.
  link(range: Range | null): void
  glow(ranges: readonly Range[]): void
  mark(findings: readonly Finding[]): void
  /// Brings a place into sight and puts the cursor there.
  reveal(range: Range): void
  dispose(): void
}

export interface SourceOptions {
  readonly label: string
  /// The learner moved the cursor, to this offset.
  cursorMoved(offset: number): void
}

export function openSource(host: HTMLElement, options: SourceOptions): SourcePane {
  const view = new EditorView({
    parent: host,
    state: EditorState.create({
      extensions: [
        EditorState.readOnly.of(true),
        EditorView.contentAttributes.of({"aria-label": options.label, "data-testid": "haskell"}),
        EditorView.lineWrapping,
        drawSelection(),
        bracketMatching(),
        highlightSelectionMatches(),
        search({top: true}),
        keymap.of([...searchKeymap, ...standardKeymap]),
        colours,
        marks,
        lintGutter(),
        EditorView.updateListener.of(update => {
          const byHand = update.transactions.some(t => t.isUserEvent("select"))
          if (byHand) options.cursorMoved(update.state.selection.main.head)
        }),
      ],
    }),
  })

  return {
    setProgram(program) {
      const old = view.state.doc.toString()
      const changes = difference(old, program.text)
      view.dispatch({
        ...(changes === null ? {} : {changes}),
        effects: programShown.of(program),
      })
    },
    link(range) {
      const effects: ReturnType<typeof setLinked.of>[] = [setLinked.of(range)]
      view.dispatch({effects})
      if (range !== null && !view.hasFocus && range.start <= view.state.doc.length)
        view.dispatch({effects: EditorView.scrollIntoView(range.start, {y: "nearest", yMargin: 40})})
    },
    glow(ranges) {
      view.dispatch({effects: setGlowing.of(ranges)})
    },
    mark(findings) {
      const length = view.state.doc.length
      const diagnostics = findings.flatMap((f): Diagnostic[] => {
        if (f.range === null || f.range.start > length) return []
        const to = Math.min(f.range.end, length)
        return [
          {
            from: Math.min(f.range.start, to),
            to,
            severity: f.severity,
            message: `${f.message} ${f.hint}`.trim().replaceAll("`", ""),
          },
        ]
      })
      view.dispatch(setDiagnostics(view.state, diagnostics))
    },
    reveal(range) {
      const at = Math.min(range.start, view.state.doc.length)
      view.dispatch({
        selection: {anchor: at},
        effects: EditorView.scrollIntoView(at, {y: "center"}),
      })
    },
    dispose() {
      view.destroy()
    },
  }
}
