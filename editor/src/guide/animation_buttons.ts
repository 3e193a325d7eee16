/// Buttons below the animations of the guide that let them stand and move. Without the script they move, unless the reader asked for reduced motion.

import {guideWords} from "./guide_words.ts"

/// The still picture is a source of its own, which is used where this media query fits.
const onPaper = "print"
const everywhere = "all"

export function addAnimationButtons(): void {
  const words = guideWords(document.documentElement.lang)
  const reduced = window.matchMedia("(prefers-reduced-motion: reduce)").matches
  for (const picture of document.querySelectorAll("picture.animation")) {
    const still = picture.querySelector("source")
    if (still === null) continue
    let moves = !reduced
    const button = document.createElement("button")
    button.type = "button"
    const show = () => {
      still.media = moves ? onPaper : everywhere
      button.textContent = moves ? words.pause : words.play
    }
    button.addEventListener("click", () => {
      moves = !moves
      show()
    })
    show()
    picture.after(button)
  }
}
