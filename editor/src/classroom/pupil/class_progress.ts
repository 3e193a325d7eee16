/// Progress in lessons in a class: that of the pupil whom the class has let in, from the class's store and from this browser.

import type {Store} from "../../browser/store.ts"
import {type Progress, union} from "../../lesson_files/progress.ts"
import type {PageState} from "../../state/page_state.ts"
import {tryToStore} from "../../storage/browser_storage.ts"
import type {PupilAnswer, PupilRequest} from "../../wire/classroom/pupil_messages.generated.ts"

/// Storage key of the class whose pupil made the progress that this browser stores.
const ownerKey = "rosy.class.progress"

export interface ClassProgress {
  /// The service has named its class.
  meets(classId: string): void
  entered(message: PupilAnswer & {readonly op: "entered"}, classId: string): void
  /// The pupil has left the class on this device.
  left(): void
}

export function openClassProgress(
  store: Store,
  storage: Storage,
  send: (message: PupilRequest) => boolean,
): ClassProgress {
  let stored: Progress = {}
  const replace = (progress: Progress) =>
    store.dispatch({kind: "lesson", event: {kind: "progress-replaced", progress}})
  /// Sends what the class does not have of the open lesson.
  const tell = ({lessons}: PageState) => {
    const {open, writing, progress} = lessons
    if (open === null || writing !== null) return
    const {name, title, steps} = open.lesson
    const done = progress[name] ?? []
    if (done.every(step => stored[name]?.includes(step))) return
    if (send({op: "progress", lesson: name, title, steps: steps.length, done}))
      stored = union(stored, {[name]: done})
  }
  store.onFrame(tell)
  const left = () => {
    stored = {}
    storage.removeItem(ownerKey)
    replace({})
  }
  return {
    meets(classId) {
      const owner = storage.getItem(ownerKey)
      if (owner !== null && owner !== classId) left()
    },
    entered({progress, programs, token}, classId) {
      const isKnown = programs.length > 0 || Object.keys(progress).length > 0
      // On a device that is new to a pupil whom the class knows, the progress before may be another learner's.
      const own = token !== null && isKnown ? {} : store.now.lessons.progress
      stored = progress
      replace(union(progress, own))
      tryToStore(storage, ownerKey, classId)
      tell(store.now)
    },
    left,
  }
}
