/// List of the lessons by course, with what is done of each.

import type {VNode} from "preact"
import type {LessonEntry} from "../../lesson_files/lesson.ts"
import {isFinished} from "../../lesson_files/progress.ts"
import {useController, usePageState} from "../../ui/app_context.ts"
import {IconButton, TextWithCode} from "../../ui/controls.tsx"
import {BinIcon} from "../../ui/icons.tsx"
import {words} from "../../words/index.ts"

export function LessonList(): VNode {
  return (
    <>
      <ServiceLessons />
      <Drafts />
    </>
  )
}

/// The lessons that are being written in this browser.
function Drafts(): VNode {
  const {lessonEditor} = useController()
  const drafts = usePageState(s => s.lessons.drafts)
  const w = words.lessonEditor
  return (
    <section>
      {drafts.length > 0 && <h3>{w.yours}</h3>}
      <ul class="draft-list">
        {drafts.map(({name, title, language}) => {
          const text = title[language] ?? Object.values(title)[0] ?? w.untitled
          return (
            <li key={name}>
              <button type="button" class="link" onClick={() => lessonEditor.open(name)}>
                {text}
              </button>
              <IconButton label={w.remove(text)} onClick={() => lessonEditor.remove(name)}>
                <BinIcon />
              </IconButton>
            </li>
          )
        })}
      </ul>
      <button type="button" class="plain" onClick={lessonEditor.begin}>
        {w.write}
      </button>
    </section>
  )
}

function ServiceLessons(): VNode {
  const controller = useController()
  const list = usePageState(s => s.lessons.list)
  if (list.kind === "failed")
    return (
      <p>
        {words.lessons.failed}{" "}
        <button type="button" class="link" onClick={() => controller.openLessons()}>
          {words.again}
        </button>
      </p>
    )
  if (list.kind !== "there") return <p class="quiet late">{words.lessons.loading}</p>
  const titles: Readonly<Record<string, string>> = words.lessons.courses
  const courses = [...new Set(list.lessons.map(lesson => lesson.course))]
  return (
    <>
      {courses.map(course => (
        <section key={course}>
          <h3>{titles[course] ?? words.lessons.otherLessons}</h3>
          <ol class="cards lessons">
            {list.lessons
              .filter(lesson => lesson.course === course)
              .map(lesson => (
                <LessonCard key={lesson.name} lesson={lesson} />
              ))}
          </ol>
        </section>
      ))}
    </>
  )
}

function LessonCard({lesson}: {lesson: LessonEntry}): VNode {
  const controller = useController()
  const progress = usePageState(s => s.lessons.progress)
  const current = usePageState(s => s.lessons.open?.lesson.name === lesson.name)
  const finished = isFinished(progress, lesson)
  const done = lesson.steps.filter(step => (progress[lesson.name] ?? []).includes(step)).length
  return (
    <li class={`card ${finished ? "finished" : ""}`} aria-current={current}>
      <button type="button" class="opens" onClick={() => controller.openLesson(lesson.name)}>
        <b>
          {lesson.number}. {lesson.title}
        </b>
        <span>
          <TextWithCode text={lesson.idea} strong={null} />
        </span>
        {done > 0 && (
          <span class="lesson-progress">
            {finished ? `✓ ${words.lessons.finished}` : words.lessons.stepsDone(done, lesson.steps.length)}
          </span>
        )}
      </button>
    </li>
  )
}
