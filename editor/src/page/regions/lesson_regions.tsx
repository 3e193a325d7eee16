/// Places of the lessons on the page. Their components are fetched when they are needed for the first time, so that the page opens without them.

import type {ComponentType, VNode} from "preact"
import {useEffect, useState} from "preact/hooks"
import {usePageState} from "../../ui/app_context.ts"
import {Dialog} from "../../ui/controls.tsx"
import {words} from "../../words/index.ts"

export function LessonRegion(): VNode | null {
  const isOpen = usePageState(s => s.lessons.open !== null)
  const isEditing = usePageState(s => s.lessons.writing?.mode === "editing")
  const Panel = useFetched(isOpen, panel)
  const Editor = useFetched(isEditing, editor)
  if (isEditing) return Editor === null ? null : <Editor />
  return isOpen && Panel !== null ? <Panel /> : null
}

export function LessonsDialog(): VNode {
  return (
    <Dialog name="lessons" title={words.lessons.title} lead={words.lessons.lead}>
      {() => <Fetched part={list} />}
    </Dialog>
  )
}

export function ChallengesDialog(): VNode {
  const {title, lead} = words.challenges
  return (
    <Dialog name="challenges" title={title} lead={lead}>
      {() => <Fetched part={challengeList} />}
    </Dialog>
  )
}

function Fetched({part}: {part: () => Promise<ComponentType>}): VNode | null {
  const Part = useFetched(true, part)
  return Part === null ? null : <Part />
}

const panel = () => import("../../features/lessons/lesson_panel.tsx").then(found => found.LessonPanel)
const editor = () =>
  import("../../features/lesson_editor/lesson_editor_panel.tsx").then(found => found.LessonEditorPanel)
const list = () => import("../../features/lessons/lesson_list.tsx").then(found => found.LessonList)
const challengeList = () =>
  import("../../features/lessons/challenge_list.tsx").then(found => found.ChallengeList)

function useFetched(isWanted: boolean, fetchIt: () => Promise<ComponentType>): ComponentType | null {
  const [found, setFound] = useState<{readonly component: ComponentType} | null>(null)
  useEffect(() => {
    if (isWanted && found === null) void fetchIt().then(component => setFound({component}))
  }, [isWanted, found, fetchIt])
  return found?.component ?? null
}
