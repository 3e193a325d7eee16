/// Plan of a term: which lessons of the page belong to which week, and how long they take.

import {readFileSync} from "node:fs"
import {join} from "node:path"
import type {LessonSource} from "./lesson_source.ts"

/// `docs/teaching/term.json`.
export interface Term {
  readonly weeks: readonly {
    readonly lessons: readonly string[]
    readonly page?: string
    readonly test?: number
  }[]
  /// Courses beside the weeks: from which week they can be taught, and their page.
  readonly strands: readonly {readonly course: string; readonly from: number; readonly page: string}[]
  /// The page with projects.
  readonly projects: string
  /// How long a step of a lesson takes, min, by its kind.
  readonly minutes: Readonly<Record<string, number>>
}

export const readTerm = (root: string): Term =>
  JSON.parse(readFileSync(join(root, "docs/teaching/term.json"), "utf8")) as Term

export const minutesOf = ({steps}: LessonSource, {minutes}: Term): number =>
  steps.reduce((sum, {kind}) => sum + (minutes[kind] ?? 0), 0)
