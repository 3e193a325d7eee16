/// The room's view on a canvas: its picture, drawn once per frame with the state, and the gestures on it.

import type {RoomState} from "../../state/runs/room_state.ts"
import type {CameraView} from "./camera.ts"
import {watchGestures} from "./gestures.ts"
import type {Pose} from "./poses.ts"
import type {QuestionTarget} from "./question_targets.ts"
import {RoomPicture, type RoomViewOptions} from "./room_picture.ts"

export interface RoomView {
  /// Draws the room if it looks different from what is drawn; answers whether something still moves, so that another frame is worth drawing.
  draw(room: RoomState, sight: RoomViewOptions, now: number): boolean
  /// Comes `factor` times closer, around the middle.
  zoom(factor: number): void
  /// Shows all of the room.
  whole(): void
  /// The theme changed: colours are read anew.
  recolour(): void
  dispose(): void
}

export interface RoomListener {
  /// The picture must be drawn again.
  changed(): void
  /// The learner took the robot to this pose (room coordinates).
  placed(pose: Pose): void
  /// The learner pushed a movable thing towards this pose, or took hold of it by keyboard.
  pushed(thing: number, pose: Pose): void
  holds(thing: number | null): void
  /// The learner took another robot to this pose, before a run.
  companionPlaced(companion: number, pose: Pose, isDropped: boolean): void
  /// The picture is to go with the robot, or no longer: the learner moved it by hand, or asked for all of the room.
  follows(follows: boolean): void
  /// The learner asks why the robot moves, shines or speaks as it does, or why it was at a point of its trail.
  asked(about: QuestionTarget): void
  /// The learner has read the answer.
  read(): void
}

export function openRoom(canvas: HTMLCanvasElement, listener: RoomListener): RoomView {
  const picture = new RoomPicture(canvas)
  const {viewport} = picture
  const changed = () => {
    picture.invalidate()
    listener.changed()
  }
  const measure = () => {
    const {width, height} = canvas.getBoundingClientRect()
    const ratio = window.devicePixelRatio || 1
    viewport.size = {w: width, h: height, ratio}
    canvas.width = Math.max(1, Math.round(width * ratio))
    canvas.height = Math.max(1, Math.round(height * ratio))
    changed()
  }
  const watcher = new ResizeObserver(measure)
  watcher.observe(canvas)
  measure()

  const looked = (to: CameraView) => {
    viewport.view = to
    changed()
  }
  const whole = () => {
    listener.follows(false)
    looked(null)
  }
  const zoomed = (factor: number, x: number, y: number) => looked(viewport.zoomed(factor, x, y))
  watchGestures(canvas, {
    camera: () => viewport.camera,
    robot: () => picture.robot,
    things: () => picture.things,
    companions: () => picture.companions,
    held: () => picture.hands.held,
    able: () => picture.hands.able,
    placed: pose => listener.placed(viewport.inside(pose)),
    pushed: (thing, pose) => listener.pushed(thing, viewport.inside(pose)),
    companionPlaced: (companion, pose, isDropped) => listener.companionPlaced(companion, pose, isDropped),
    holds(held) {
      // At once: the next key may come before the next picture.
      picture.hands = {...picture.hands, held}
      listener.holds(held)
    },
    handled(handle) {
      if (picture.hands.handle === handle) return
      picture.hands = {...picture.hands, handle}
      changed()
    },
    panned: (dx, dy) => {
      if (viewport.view === null) return
      listener.follows(false)
      looked(viewport.panned(dx, dy))
    },
    zoomed,
    fitted: whole,
    followed: () => listener.follows(!picture.follows),
    targetAt: (at, reach) => picture.targetAt(at, reach),
    asked: about => listener.asked(about),
    read: () => listener.read(),
  })

  const recolour = () => {
    picture.recolour()
    changed()
  }
  // A browser may drop what is drawn, as after a fault of the graphics card.
  canvas.addEventListener("contextrestored", recolour)

  return {
    draw: (room, sight, now) => picture.draw(room, sight, now),
    zoom: factor => zoomed(factor, viewport.seen().w / 2, viewport.seen().h / 2),
    whole,
    recolour,
    dispose() {
      watcher.disconnect()
      canvas.removeEventListener("contextrestored", recolour)
    },
  }
}
