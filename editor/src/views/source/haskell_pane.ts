/// Haskell pane: CodeMirror, synchronized with the blocks. Edits go out as text with their changes; text from blocks or undo is applied as a minimal change, so
/// that cursor and scroll position are preserved.

import {closeBrackets, closeBracketsKeymap} from "@codemirror/autocomplete"
import {defaultKeymap, indentLess, indentMore} from "@codemirror/commands"
import {bracketMatching} from "@codemirror/language"
import {lintGutter, lintKeymap, openLintPanel, setDiagnostics} from "@codemirror/lint"
import {highlightSelectionMatches, search, searchKeymap} from "@codemirror/search"
import {
  Annotation,
  type ChangeSet,
  Compartment,
  EditorState,
  type Extension,
  Transaction,
} from "@codemirror/state"
import {EditorView, keymap} from "@codemirror/view"
import type {Finding} from "../../program/program.ts"
import {changesBetween} from "../../program/text_changes.ts"
import {commentLines, setComments} from "./comment_lines.ts"
import {compilerInfoField, completion, setCompilerInfo} from "./completion.ts"
import type {Range} from "./decorations.ts"
import {
  cursorCorrection,
  focusRelease,
  isLinked,
  lineDecorations,
  setExplained,
  setGlowing,
  setLinked,
} from "./decorations.ts"
import {diagnosticsOf, saidBy, standThere} from "./diagnostics.ts"
import {openDropPreview} from "./drop_preview.ts"
import type {HaskellPane, SourceOptions} from "./haskell_pane_types.ts"
import {indentation} from "./indentation.ts"
import {numberDragging} from "./number_drag.ts"
import {renamePanel, renameShortcut} from "./rename_panel.ts"
import {openSharedText, type SharedText, sharedText} from "./shared_text.ts"
import {ownKeys} from "./shortcuts.ts"
import {programShown, syntaxColouring} from "./syntax_colouring.ts"
import {tooltips} from "./tooltips.ts"
import {setTaken, setValues, valueWidgets} from "./value_widgets.ts"

/// Marks changes that come from the page and not from the learner.
const fromPage = Annotation.define<true>()

function extensionsOf(
  options: SourceOptions,
  marks: ProblemMarks,
  editable: Compartment,
  sharing: Compartment,
): Extension[] {
  // Tab indents after typing; in a walk through the page by keyboard it goes on to the next
  // part (WCAG 2.2 §2.1.2: no keyboard trap).
  let writing = false
  return [
    editable.of(EditorState.readOnly.of(true)),
    EditorView.contentAttributes.of({
      "aria-label": options.label,
      "aria-description": options.description,
      "data-testid": "haskell",
      spellcheck: "false",
    }),
    EditorView.lineWrapping,
    bracketMatching(),
    closeBrackets(),
    highlightSelectionMatches(),
    search({top: true}),
    indentation,
    compilerInfoField,
    completion(options.completer),
    tooltips(options.explainer),
    renamePanel(options.renamer),
    EditorState.phrases.of(options.phrases),
    keymap.of([
      {key: ownKeys.mend, run: v => marks.mendAtCursor(v)},
      renameShortcut,
      {key: ownKeys.format, run: () => (options.format(), true)},
      {key: ownKeys.why, run: v => (options.asked(v.state.selection.main.head), true)},
      ...closeBracketsKeymap,
      ...searchKeymap,
      ...lintKeymap,
      ...defaultKeymap,
      {key: "Tab", run: v => writing && indentMore(v), shift: v => writing && indentLess(v)},
      // Escape before Tab leaves after all; other uses of Escape go on.
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
    numberDragging(options.numbers),
    cursorCorrection,
    focusRelease,
    syntaxColouring,
    lineDecorations,
    valueWidgets(options.valueClicked),
    commentLines,
    lintGutter(),
    sharing.of([]),
    EditorView.updateListener.of(update => {
      const mine = update.transactions.some(t => t.annotation(fromPage) === true)
      const isOwn = update.transactions.every(t => t.annotation(Transaction.remote) !== true)
      if (update.docChanged && !mine && isOwn) writing = true
      if (update.focusChanged && !update.view.hasFocus) writing = false
      if (update.docChanged && !mine) {
        const text = update.state.doc.toString()
        options.edited(text, update.changes, isOwn)
        if (update.transactions.some(t => t.isUserEvent("input.paste") || t.isUserEvent("input.drop")))
          options.pasted(text, insertedIn(update.changes))
      } else if (update.selectionSet && update.transactions.some(t => t.isUserEvent("select")))
        options.cursorMoved(update.state.selection.main.head)
    }),
  ]
}

/// Where the text has what was put in.
function insertedIn(changes: ChangeSet): readonly Range[] {
  const inserted: Range[] = []
  changes.iterChanges((_from, _to, start, end) => inserted.push({start, end}))
  return inserted
}

/// Underlines of the problems, and their fixes.
class ProblemMarks {
  private found: readonly Finding[] = []
  /// What the marks say that are shown, in the order of `found`.
  private marked = ""
  private markedLines = 0
  private readonly options: SourceOptions

  constructor(options: SourceOptions) {
    this.options = options
  }

  /// Mends the problem at the cursor when there is one way to do it, and shows the ways when there are several.
  mendAtCursor(view: EditorView): boolean {
    const {head} = view.state.selection.main
    const line = view.state.doc.lineAt(head)
    const near = this.found.filter(
      f => f.range !== null && f.range.start <= line.to && f.range.end >= line.from,
    )
    const fixes = near.flatMap(f => f.fixes)
    const [first] = fixes.length > 0 ? fixes : [this.options.fixHere(head)]
    if (fixes.length > 1) return openLintPanel(view)
    if (first === undefined || first === null) return false
    this.options.mend(first)
    return true
  }

  show(view: EditorView, findings: readonly Finding[]): void {
    this.found = findings
    // What is typed moves the places of a fix: it is taken as it is then.
    const diagnostics = diagnosticsOf(findings, view.state.doc.length, (finding, n) => {
      const fix = this.found[finding]?.fixes[n]
      if (fix !== undefined) this.options.mend(fix)
    })
    const said = diagnostics.map(saidBy).join("\n\n")
    const {lines} = view.state.doc
    // Underlines move with the text; the dots beside it stay behind when lines come or go.
    if (said === this.marked && lines === this.markedLines && standThere(view.state, diagnostics)) return
    this.marked = said
    this.markedLines = lines
    view.dispatch(setDiagnostics(view.state, diagnostics))
  }
}

/// Where the cursor and the text in sight are, and how they get elsewhere.
function cursorOf(view: EditorView): Pick<HaskellPane, "cursor" | "reveal" | "position" | "goTo" | "select"> {
  return {
    cursor: () => view.state.selection.main.head,
    reveal(range) {
      const at = Math.min(range.start, view.state.doc.length)
      view.dispatch({
        selection: {anchor: at},
        effects: EditorView.scrollIntoView(at, {y: "center"}),
      })
    },
    position() {
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
    select(range) {
      const {length} = view.state.doc
      view.dispatch({
        selection: {anchor: Math.min(range.start, length), head: Math.min(range.end, length)},
        scrollIntoView: true,
      })
      view.focus()
    },
  }
}

function sharingOf(
  view: EditorView,
  sharing: Compartment,
): Pick<HaskellPane, "share" | "shared" | "endSharing"> {
  let shared: SharedText | null = null
  return {
    share(side, name, changed) {
      const told = EditorView.updateListener.of(update => {
        if (update.docChanged || update.selectionSet) changed()
      })
      view.dispatch({effects: sharing.reconfigure([sharedText(side, name), told])})
      shared = openSharedText(view)
      return shared
    },
    shared: () => shared,
    endSharing() {
      shared = null
      view.dispatch({effects: sharing.reconfigure([])})
    },
  }
}

export function openHaskellPane(host: HTMLElement, options: SourceOptions): HaskellPane {
  const editable = new Compartment()
  const sharing = new Compartment()
  const marks = new ProblemMarks(options)
  const extensions = extensionsOf(options, marks, editable, sharing)
  const view = new EditorView({parent: host, state: EditorState.create({extensions})})
  const carrying = openDropPreview(view)
  return {
    ...cursorOf(view),
    ...sharingOf(view, sharing),
    setProgram(program, known) {
      const changes = known ?? changesBetween(view.state.doc.toString(), program.text)
      view.dispatch({
        ...(changes.empty ? {} : {changes}),
        annotations: fromPage.of(true),
        effects: programShown.of(program),
      })
    },
    setEditable(on) {
      view.dispatch({effects: editable.reconfigure(EditorState.readOnly.of(!on))})
    },
    setTold(told) {
      view.dispatch({effects: setCompilerInfo.of(told)})
    },
    link(range) {
      if (!isLinked(view.state, range)) view.dispatch({effects: setLinked.of(range)})
      if (range !== null && !view.hasFocus && range.start <= view.state.doc.length)
        view.dispatch({effects: EditorView.scrollIntoView(range.start, {y: "nearest", yMargin: 40})})
    },
    glow(ranges) {
      view.dispatch({effects: setGlowing.of(ranges)})
    },
    explain(ranges) {
      view.dispatch({effects: setExplained.of(ranges)})
    },
    showValues(values, taken) {
      view.dispatch({effects: [setValues.of(values), setTaken.of(taken)]})
    },
    showComments(comments) {
      view.dispatch({effects: setComments.of(comments)})
    },
    mark: findings => marks.show(view, findings),
    offsetAt(x, y) {
      return view.posAtCoords({x, y}, false)
    },
    previewDrop(carried) {
      carrying.show(carried)
    },
    dropArea() {
      if (view.state.readOnly || host.offsetParent === null) return null
      const area = host.getBoundingClientRect()
      return area.width === 0 || area.height === 0 ? null : area
    },
    dispose() {
      carrying.show(null)
      view.destroy()
    },
  }
}
