/// The Haskell pane: CodeMirror, in step with the blocks. What the learner types goes out as text; what comes in from
/// the blocks or from undo is set with as few changes as it takes, so that the cursor and the scroll position stay.

import {closeBrackets, closeBracketsKeymap} from "@codemirror/autocomplete"
import {defaultKeymap, indentLess, indentMore} from "@codemirror/commands"
import {bracketMatching} from "@codemirror/language"
import {
  type Diagnostic,
  forEachDiagnostic,
  lintGutter,
  lintKeymap,
  openLintPanel,
  setDiagnostics,
} from "@codemirror/lint"
import {highlightSelectionMatches, search, searchKeymap} from "@codemirror/search"
import {Annotation, Compartment, EditorState} from "@codemirror/state"
import {drawSelection, EditorView, keymap} from "@codemirror/view"
import type {Fix} from "../state/fixes.ts"
import type {Finding, Program} from "../state/program.ts"
import {caret} from "./caret.ts"
import {type Carried, showCarried} from "./carried.ts"
import {colours, programShown} from "./colours.ts"
import {difference} from "./difference.ts"
import {type Explainer, explain} from "./explain.ts"
import {ownKeys} from "./keys.ts"
import {knowledge, setTold, type Told} from "./known.ts"
import {layout} from "./layout.ts"
import {marks, type Range, setGlowing, setLinked} from "./marks.ts"
import {type Completer, names} from "./names.ts"
import {type Renamer, renameKey, renaming} from "./rename.ts"

export interface SourcePane {
  setProgram(program: Program): void
  /// Whether the learner may type; before text can be read it is only shown.
  setEditable(editable: boolean): void
  /// What the compiler knows of names and places, for completion and explanations.
  setTold(told: Told): void
  /// Marks the text of the block under the cursor; scrolls to it unless the cursor is in the text itself.
  link(range: Range | null): void
  glow(ranges: readonly Range[]): void
  mark(findings: readonly Finding[]): void
  /// Where the cursor is.
  cursor(): number
  /// Brings a place into sight and puts the cursor there.
  reveal(range: Range): void
  /// The offset under a place on the screen, and the way it shows itself there; `null` outside of the text.
  aim(x: number, y: number): number | null
  /// Shows where a piece of text would go; `null` ends that.
  carry(carried: Carried | null): void
  /// Where the text is on the screen; `null` while it is not to be seen or not to be changed.
  area(): DOMRect | null
  /// What is selected, where the first line in sight starts, and whether the pane has the keyboard.
  place(): Spot
  /// Selects and scrolls to what `place` once told.
  goTo(spot: Spot): void
  /// Selects a place, and gives the pane the keyboard.
  choose(range: Range): void
  dispose(): void
}

export interface Spot {
  readonly anchor: number
  readonly head: number
  readonly top: number
  readonly writes: boolean
}

export interface SourceOptions {
  readonly label: string
  /// What a screen reader adds: how to leave.
  readonly description: string
  readonly completer: Completer
  readonly explainer: Explainer
  readonly renamer: Renamer
  /// CodeMirror's own words, for its search and its lists.
  readonly phrases: {readonly [phrase: string]: string}
  /// Letters that a program has at most, and what happens instead when somebody puts in more.
  readonly longest: number
  tooLong(): void
  /// The learner wants the text laid out anew.
  format(): void
  /// The learner moved the cursor, to this offset.
  cursorMoved(offset: number): void
  /// The learner changed the text.
  edited(text: string): void
  /// The learner chose a way to mend a problem.
  mend(fix: Fix): void
  /// What can be made better at a place that has no problem.
  fixHere(offset: number): Fix | null
}

/// Marks changes that come from the page and not from the learner.
const fromPage = Annotation.define<true>()

export function openSource(host: HTMLElement, options: SourceOptions): SourcePane {
  const editable = new Compartment()
  // Tab indents for somebody who writes; for somebody who walks through the page by keyboard it goes on to the next
  // part (WCAG 2.2 §2.1.2: no keyboard trap).
  let writing = false
  /// Mends the problem at the cursor when there is one way to do it, and shows the ways when there are several.
  const mendHere = (v: EditorView): boolean => {
    const {head} = v.state.selection.main
    const line = v.state.doc.lineAt(head)
    const near = found.filter(f => f.range !== null && f.range.start <= line.to && f.range.end >= line.from)
    const fixes = near.flatMap(f => f.fixes)
    const [first] = fixes.length > 0 ? fixes : [options.fixHere(head)]
    if (fixes.length > 1) return openLintPanel(v)
    if (first === undefined || first === null) return false
    options.mend(first)
    return true
  }
  let found: readonly Finding[] = []
  /// What the marks say that are shown, in the order of `found`.
  let marked = ""
  let markedLines = 0
  const view = new EditorView({
    parent: host,
    state: EditorState.create({
      extensions: [
        editable.of(EditorState.readOnly.of(true)),
        EditorView.contentAttributes.of({
          "aria-label": options.label,
          "aria-description": options.description,
          "data-testid": "haskell",
          spellcheck: "false",
        }),
        EditorView.lineWrapping,
        drawSelection(),
        bracketMatching(),
        closeBrackets(),
        highlightSelectionMatches(),
        search({top: true}),
        layout,
        knowledge,
        names(options.completer),
        explain(options.explainer),
        renaming(options.renamer),
        EditorState.phrases.of(options.phrases),
        keymap.of([
          {key: ownKeys.mend, run: mendHere},
          renameKey,
          {key: ownKeys.format, run: () => (options.format(), true)},
          ...closeBracketsKeymap,
          ...searchKeymap,
          ...lintKeymap,
          ...defaultKeymap,
          {key: "Tab", run: v => writing && indentMore(v), shift: v => writing && indentLess(v)},
          // Whoever wants to leave after all presses Escape first; other uses of Escape go on.
          {key: "Escape", run: () => (writing = false)},
        ]),
        // What is longer than a program may be costs the page minutes; it is refused as a whole, and nothing is cut.
        EditorState.changeFilter.of(change => {
          const {length, newLength} = change.changes
          const fits = newLength <= options.longest || newLength <= length
          if (fits || change.annotation(fromPage) === true) return true
          options.tooLong()
          return false
        }),
        // Tabs and foreign line ends become what the rest of the program has.
        EditorState.tabSize.of(8),
        EditorView.clipboardInputFilter.of(text => text.replaceAll("\t", "        ")),
        // A browser puts its own cursor to the start of what comes into focus, and CodeMirror moves it from there a moment later. A letter that comes first is
        // not to go astray.
        EditorView.domEventObservers({focus: (_event, v) => v.focus()}),
        caret,
        colours,
        marks,
        lintGutter(),
        EditorView.updateListener.of(update => {
          const mine = update.transactions.some(t => t.annotation(fromPage) === true)
          if (update.docChanged && !mine) writing = true
          if (update.focusChanged && !update.view.hasFocus) writing = false
          if (update.docChanged && !mine) options.edited(update.state.doc.toString())
          else if (update.selectionSet && update.transactions.some(t => t.isUserEvent("select")))
            options.cursorMoved(update.state.selection.main.head)
        }),
      ],
    }),
  })

  const carrying = showCarried(view)
  return {
    setProgram(program) {
      const changes = difference(view.state.doc.toString(), program.text)
      view.dispatch({
        ...(changes === null ? {} : {changes}),
        annotations: fromPage.of(true),
        effects: programShown.of(program),
      })
    },
    setEditable(on) {
      view.dispatch({effects: editable.reconfigure(EditorState.readOnly.of(!on))})
    },
    setTold(told) {
      view.dispatch({effects: setTold.of(told)})
    },
    link(range) {
      view.dispatch({effects: setLinked.of(range)})
      if (range !== null && !view.hasFocus && range.start <= view.state.doc.length)
        view.dispatch({effects: EditorView.scrollIntoView(range.start, {y: "nearest", yMargin: 40})})
    },
    glow(ranges) {
      view.dispatch({effects: setGlowing.of(ranges)})
    },
    mark(findings) {
      found = findings
      const length = view.state.doc.length
      const diagnostics = findings.flatMap((f, i): Diagnostic[] => {
        if (f.range === null || f.range.start > length) return []
        const to = Math.min(f.range.end, length)
        return [
          {
            from: Math.min(f.range.start, to),
            to,
            severity: f.severity,
            message: `${f.message} ${f.hint}`.trim().replaceAll("`", ""),
            // The way to mend it as it is then: what is typed moves its places.
            actions: f.fixes.map(({title}, n) => ({
              name: title,
              apply() {
                const fix = found[i]?.fixes[n]
                if (fix !== undefined) options.mend(fix)
              },
            })),
          },
        ]
      })
      const said = diagnostics.map(saidBy).join("\n\n")
      const {lines} = view.state.doc
      // Underlines move with the text; the dots beside it stay behind when lines come or go.
      if (said === marked && lines === markedLines && standThere(view.state, diagnostics)) return
      marked = said
      markedLines = lines
      view.dispatch(setDiagnostics(view.state, diagnostics))
    },
    cursor: () => view.state.selection.main.head,
    reveal(range) {
      const at = Math.min(range.start, view.state.doc.length)
      view.dispatch({
        selection: {anchor: at},
        effects: EditorView.scrollIntoView(at, {y: "center"}),
      })
    },
    aim(x, y) {
      return view.posAtCoords({x, y}, false)
    },
    carry(carried) {
      carrying.show(carried)
    },
    area() {
      if (view.state.readOnly || host.offsetParent === null) return null
      const area = host.getBoundingClientRect()
      return area.width === 0 || area.height === 0 ? null : area
    },
    place() {
      const {anchor, head} = view.state.selection.main
      const top = view.lineBlockAtHeight(view.scrollDOM.scrollTop).from
      return {anchor, head, top, writes: view.hasFocus}
    },
    goTo({anchor, head, top, writes}) {
      const within = (offset: number) => Math.max(0, Math.min(offset, view.state.doc.length))
      view.dispatch({
        selection: {anchor: within(anchor), head: within(head)},
        effects: EditorView.scrollIntoView(within(top), {y: "start", yMargin: 0}),
      })
      if (writes) view.focus()
    },
    choose(range) {
      const {length} = view.state.doc
      view.dispatch({
        selection: {anchor: Math.min(range.start, length), head: Math.min(range.end, length)},
        scrollIntoView: true,
      })
      view.focus()
    },
    dispose() {
      carrying.show(null)
      view.destroy()
    },
  }
}

/// What a mark says, wherever it stands.
function saidBy({severity, message, actions = []}: Diagnostic): string {
  return [severity, message, ...actions.map(action => action.name)].join("\n")
}

/// Whether these stand where what the pane shows has moved to by itself.
function standThere(state: EditorState, wanted: readonly Diagnostic[]): boolean {
  const at = (d: Diagnostic, from: number, to: number) => `${from} ${to} ${saidBy(d)}`
  const there = new Set<string>()
  forEachDiagnostic(state, (d, from, to) => there.add(at(d, from, to)))
  return wanted.every(d => there.has(at(d, d.from, d.to)))
}
