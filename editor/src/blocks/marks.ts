/// Marks on blocks that come from elsewhere: problems, the place of the text cursor, functions that fired.
///
/// A mark is a class on the block's group (the rest is `style.ts`), and for a problem also an icon with its sentence.

import type {BlockId, BlockProblem} from "@rosy/codegen"
import * as Blockly from "blockly/core"
import {worn} from "./infer.ts"

/// Milliseconds that a block glows after its function fired; long enough to be seen at 50 firings a second.
const glowTime = 450

const problemIcon = "rosy"

export class Marks {
  private readonly workspace: Blockly.WorkspaceSvg
  private inferred: readonly BlockProblem[] = []
  private told: readonly BlockProblem[] = []
  private accepted = false
  private waiting = false
  private loose: ReadonlySet<BlockId | undefined> = new Set()
  private highlighted: readonly BlockId[] = []
  private dimmed: readonly BlockId[] = []
  private readonly worded = new Map<BlockId, string>()
  private readonly glowing = new Map<BlockId, number>()

  constructor(workspace: Blockly.WorkspaceSvg) {
    this.workspace = workspace
  }

  /// Problems that inference found in the blocks as they are.
  setInferred(problems: readonly BlockProblem[]): void {
    this.inferred = problems
    this.showProblems()
  }

  /// Problems from elsewhere (the compiler, a run); they stand until the next call.
  /// `accepted` says that the compiler has taken the program: what inference has against it is then not worn.
  setTold(problems: readonly BlockProblem[], accepted: boolean): void {
    this.told = problems
    this.accepted = accepted
    this.showProblems()
  }

  /// Shows what was learnt while something was being moved.
  dropped(): void {
    if (this.waiting) this.showProblems()
  }

  // Icons make blocks wider: nothing shifts under a hand that is about to let go.
  private showProblems(): void {
    this.waiting = this.workspace.isDragging()
    if (this.waiting) return
    const sentences = new Map<BlockId, string[]>()
    for (const problem of [...(this.accepted ? [] : worn(this.inferred)), ...this.told]) {
      if (problem.block === undefined) continue
      const all = sentences.get(problem.block) ?? []
      const sentence = problem.hint === "" ? problem.message : `${problem.message} ${problem.hint}`
      if (!all.includes(sentence)) all.push(sentence)
      sentences.set(problem.block, all)
    }
    const loose = new Set(
      this.inferred.filter(problem => problem.kind === "loose").map(problem => problem.block),
    )
    for (const id of [...this.loose, ...loose])
      if (id !== undefined) toggle(this.workspace.getBlockById(id), "rosyLoose", loose.has(id))
    this.loose = loose
    for (const id of new Set([...this.worded.keys(), ...sentences.keys()])) {
      const block = this.workspace.getBlockById(id)
      const words = sentences.get(id)?.join("\n") ?? ""
      if (block === null) this.worded.delete(id)
      if (block === null || block.isInsertionMarker() || (this.worded.get(id) ?? "") === words) continue
      if (words === "") this.worded.delete(id)
      else this.worded.set(id, words)
      withoutEvents(() => block.setWarningText(words === "" ? null : words, problemIcon))
      toggle(block, "rosyWrong", words !== "")
    }
  }

  /// Some blocks were replaced: their marks are gone with them.
  forget(): void {
    for (const id of this.worded.keys())
      if (this.workspace.getBlockById(id)?.getSvgRoot().classList.contains("rosyWrong") !== true)
        this.worded.delete(id)
    this.showProblems()
    this.highlight(this.highlighted)
    this.dim(this.dimmed)
  }

  /// The blocks that the cursor in the text is in.
  highlight(ids: readonly BlockId[]): void {
    for (const id of this.highlighted) toggle(this.workspace.getBlockById(id), "rosyTold", false)
    for (const id of ids) toggle(this.workspace.getBlockById(id), "rosyTold", true)
    this.highlighted = ids
  }

  /// Blocks that show what their text was before it broke.
  dim(ids: readonly BlockId[]): void {
    for (const id of this.dimmed) toggle(this.workspace.getBlockById(id), "rosyDim", false)
    for (const id of ids) toggle(this.workspace.getBlockById(id), "rosyDim", true)
    this.dimmed = ids
  }

  /// Lets blocks glow for a moment; those that glow already go on.
  glow(ids: readonly BlockId[]): void {
    for (const id of ids) {
      const running = this.glowing.get(id)
      if (running !== undefined) window.clearTimeout(running)
      else toggle(this.workspace.getBlockById(id), "rosyFired", true)
      this.glowing.set(
        id,
        window.setTimeout(() => {
          this.glowing.delete(id)
          toggle(this.workspace.getBlockById(id), "rosyFired", false)
        }, glowTime),
      )
    }
  }

  dispose(): void {
    for (const timer of this.glowing.values()) window.clearTimeout(timer)
    this.glowing.clear()
  }
}

function toggle(block: Blockly.BlockSvg | null, name: string, on: boolean): void {
  block?.getSvgRoot().classList.toggle(name, on)
}

/// Icons come and go through events, which would count as the learner's edits.
function withoutEvents(act: () => void): void {
  Blockly.Events.disable()
  try {
    act()
  } finally {
    Blockly.Events.enable()
  }
}
