/// Script of the shared page: draws the film of a run on the canvas, and plays it. The slider and the button are those of HTML and work by keyboard. Nothing
/// moves before a person presses Play; where less motion is wanted, the film advances in steps.

import {type Palette, readPalette} from "../../views/room/palette.ts"
import {durationOf, type Film} from "./film.ts"
import {drawFilm} from "./film_drawing.ts"

function element<T extends HTMLElement>(id: string): T {
  const found = document.getElementById(id)
  if (found === null) throw new Error(`expected #${id} in the shared page, found none`)
  return found as T
}

const film = JSON.parse(element("film").textContent ?? "") as Film
const canvas = element<HTMLCanvasElement>("room")
const button = element<HTMLButtonElement>("play")
const slider = element<HTMLInputElement>("time")
const clock = element<HTMLOutputElement>("clock")
const ctx = canvas.getContext("2d")
const {from, to} = durationOf(film)
const [width, height] = film.world.size

const lessMotion = window.matchMedia("(prefers-reduced-motion: reduce)")
const dark = window.matchMedia("(prefers-color-scheme: dark)")
/// Seconds of the run between two pictures where less motion is wanted.
const quietStep = 1

const seconds = new Intl.NumberFormat(document.documentElement.lang, {
  minimumFractionDigits: 1,
  maximumFractionDigits: 1,
})

let palette: Palette = readPalette(document.documentElement)
/// A whole room fits into most windows with the controls below it.
const mostHeight = 0.6
/// The time that is shown, s; the end shows the whole path.
let shown = to
/// When the playing film would have been at its start, on the clock of the page, ms; `null` while it is paused.
let startedAt: number | null = null

function draw(): void {
  const w = canvas.parentElement?.clientWidth ?? 300
  const h = Math.min(Math.round((w * height) / width) + 36, Math.round(window.innerHeight * mostHeight))
  const ratio = window.devicePixelRatio || 1
  canvas.width = w * ratio
  canvas.height = h * ratio
  if (ctx !== null) drawFilm(ctx, film, shown, {w, h, ratio}, palette)
}

function show(time: number): void {
  shown = Math.min(to, Math.max(from, time))
  slider.value = `${shown}`
  const text = `${seconds.format(shown)} s`
  clock.value = text
  slider.setAttribute("aria-valuetext", text)
  draw()
}

function pause(): void {
  startedAt = null
  button.textContent = button.dataset["play"] ?? ""
}

function play(): void {
  const first = shown >= to ? from : shown
  startedAt = performance.now() - (first - from) * 1000
  button.textContent = button.dataset["pause"] ?? ""
  show(first)
  requestAnimationFrame(advance)
}

function advance(now: number): void {
  if (startedAt === null) return
  const passed = Math.max(0, (now - startedAt) / 1000)
  const time = from + passed
  if (!lessMotion.matches || time >= to) show(time)
  else if (Math.abs(time - shown) >= quietStep) show(from + Math.floor(passed / quietStep) * quietStep)
  if (time >= to) pause()
  else requestAnimationFrame(advance)
}

slider.min = `${from}`
slider.max = `${to}`
button.addEventListener("click", () => (startedAt === null ? play() : pause()))
slider.addEventListener("input", () => {
  pause()
  show(Number(slider.value))
})
window.addEventListener("resize", draw)
dark.addEventListener("change", () => {
  palette = readPalette(document.documentElement)
  draw()
})
show(to)
