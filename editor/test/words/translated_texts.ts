/// All texts in a language: of the page, of blocks, of lessons, of the service and of the guide, each with the file it is in.
///
/// Texts are read from the files, so that those that are made of parts are there too. Comments and ids are left out.

import {readdirSync, readFileSync} from "node:fs"
import {fileURLToPath} from "node:url"

export type Translation = "de" | "fr" | "es" | "pt"

export interface TranslatedText {
  readonly file: string
  readonly text: string
}

const root = fileURLToPath(new URL("../../../", import.meta.url))

const filesBelow = (folder: string): string[] =>
  readdirSync(`${root}${folder}`, {recursive: true, withFileTypes: true})
    .filter(entry => entry.isFile() && /\.(ts|md|txt)$/.test(entry.name))
    .map(entry => `${entry.parentPath.slice(root.length)}/${entry.name}`)

/// Lines of a file of words that are not comments.
const linesOf = (text: string): string[] => text.split("\n").filter(line => !/^\s*(\/\/|import )/.test(line))

/// The values of a JSON file, without its keys, which are ids or English sentences.
function valuesOf(json: unknown): string[] {
  if (typeof json === "string") return [json]
  if (typeof json !== "object" || json === null) return []
  return Object.values(json).flatMap(valuesOf)
}

/// Paragraphs of a page of the guide, without its programs.
const paragraphsOf = (text: string): string[] => text.replaceAll(/```[\s\S]*?```/g, "").split("\n")

function textsOf(file: string): readonly TranslatedText[] {
  const text = readFileSync(`${root}${file}`, "utf8")
  const parts = file.endsWith(".json")
    ? valuesOf(JSON.parse(text))
    : file.endsWith(".md")
      ? paragraphsOf(text)
      : linesOf(text)
  return parts.map(part => ({file, text: part}))
}

export function translatedTexts(tag: Translation): readonly TranslatedText[] {
  const lessons = readdirSync(`${root}examples/lessons`, {withFileTypes: true})
    .filter(entry => entry.isDirectory())
    .map(({name}) => `examples/lessons/${name}/texts/${tag}.json`)
  const folders = [`languages/${tag}`, `docs/${tag}`]
  return [...folders.flatMap(filesBelow), ...lessons, `languages/${tag}/sentences.json`].flatMap(textsOf)
}
