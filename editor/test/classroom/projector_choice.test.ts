/// What a board shows of the projector while its requests and the news of earlier choices are under way.

import {expect, test} from "vitest"
import {choiceHeard, lookAt, type ProjectorChoice} from "../../src/classroom/messages/projector_choice.ts"

const nothing: ProjectorChoice = {
  projecting: null,
  projectingTask: null,
  projectorSight: {named: false, program: false},
  sightAsked: null,
}

test("what the service tells is shown", () => {
  const {choice, request} = choiceHeard(nothing, {pupil: 3, named: true, program: false, task: null})
  expect(choice).toEqual({
    projecting: 3,
    projectingTask: null,
    projectorSight: {named: true, program: false},
    sightAsked: null,
  })
  expect(request).toBeNull()
})

test("a change is asked for at once when a pupil is shown", () => {
  const {choice, request} = lookAt({...nothing, projecting: 3}, {named: true})
  expect(request).toEqual({op: "project", pupil: 3, named: true, program: false})
  expect(choice.projectorSight).toEqual({named: true, program: false})
})

test("changes before the service has told of the pupil are asked for when it does", () => {
  const named = lookAt(nothing, {named: true})
  expect(named.request).toBeNull()
  const both = lookAt(named.choice, {program: true})
  const heard = choiceHeard(both.choice, {pupil: 3, named: false, program: false, task: null})
  expect(heard.request).toEqual({op: "project", pupil: 3, named: true, program: true})
  expect(heard.choice.projectorSight).toEqual({named: true, program: true})
})

test("news of an earlier choice takes back no later one", () => {
  const named = lookAt({...nothing, projecting: 3}, {named: true})
  const stale = choiceHeard(named.choice, {pupil: 3, named: false, program: false, task: null})
  expect(stale.choice.projectorSight).toEqual({named: true, program: false})
  expect(stale.request).toBeNull()
  const both = lookAt(stale.choice, {program: true})
  expect(both.request).toEqual({op: "project", pupil: 3, named: true, program: true})
  const told = choiceHeard(both.choice, {pupil: 3, named: true, program: true, task: null})
  expect(told.choice.sightAsked).toBeNull()
  // From now on the choice of another board counts.
  const other = choiceHeard(told.choice, {pupil: 4, named: false, program: true, task: null})
  expect(other.choice.projectorSight).toEqual({named: false, program: true})
})

test("nobody is shown any more, and the way to show pupils stays", () => {
  const shown: ProjectorChoice = {
    projecting: 3,
    projectingTask: null,
    projectorSight: {named: true, program: true},
    sightAsked: null,
  }
  const {choice} = choiceHeard(shown, {pupil: null, named: false, program: false, task: null})
  expect(choice).toEqual({...shown, projecting: null})
})

test("the standings of a task take the place of a pupil, and the next pupil takes theirs", () => {
  const shown = choiceHeard(nothing, {pupil: null, named: false, program: false, task: 2}).choice
  expect(shown).toMatchObject({projecting: null, projectingTask: 2})
  const other = choiceHeard(shown, {pupil: 4, named: false, program: false, task: null}).choice
  expect(other).toMatchObject({projecting: 4, projectingTask: null})
})
