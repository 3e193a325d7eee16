/// The words around the pages of the guide in English.

export const guide = {
  brand: "Rosy guide",
  skip: "To the text",
  search: "Search the guide",
  contents: "Contents",
  turn: "Next and previous page",
  before: "Before:",
  next: "Next:",
  openRosy: "Open Rosy",
  openProgram: "Open in Rosy",
  here: "Link to this part",
  /// Buttons below an animation.
  pause: "Pause the animation",
  play: "Play the animation",
  away: "The search is not there: the connection to Rosy is gone.",
  nothingAbout: (query: string) => `Nothing about “${query}”. Try another word, or only its beginning.`,
  places: (count: number) => (count === 1 ? "1 place" : `${count} places`),
  /// Behind a page that is not translated.
  inEnglish: "in English",
  /// Link to this language from the same page in another one.
  readHere: "This page in English",
}

export type GuideWords = typeof guide
