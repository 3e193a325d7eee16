/// Lessons that a page had open when the service began to run another class: each opens again when its own class is back. Kept as long as the page.

import {showLesson} from "../../controller/lessons/lessons.ts"
import type {Lesson} from "../../lesson_files/lesson.ts"
import type {PageOfClass} from "./page_of_class.ts"

interface InterruptedLesson {
  readonly lesson: Lesson
  /// The step that was shown.
  readonly at: number
  /// The entry of the program beside it in the program store; `null` for the lesson's own, unchanged.
  readonly program: string | null
}

export interface InterruptedLessons {
  /// A pupil's page leaves this class for another one; what is open is stored already.
  interrupt(classId: string): void
  /// The pupil is in this class again, and the pupil's program is shown.
  goOn(classId: string): void
}

export function openInterruptedLessons({
  store,
  loader,
}: Pick<PageOfClass, "store" | "loader">): InterruptedLessons {
  const interrupted = new Map<string, InterruptedLesson>()
  return {
    interrupt(classId) {
      const {open, writing} = store.now.lessons
      if (open === null || writing !== null) return
      interrupted.set(classId, {lesson: open.lesson, at: open.at, program: loader.storedId()})
    },
    goOn(classId) {
      const found = interrupted.get(classId)
      interrupted.delete(classId)
      if (found === undefined) return
      const {lesson, at, program} = found
      // Where another program was changed last, on another device, the pupil goes on with that one.
      if (program === null || program === loader.storedId())
        showLesson(store, loader, lesson, at, program === null)
    },
  }
}
