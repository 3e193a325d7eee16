/// One word for one idea in each language, and the register and the typography that schools use there: `du`, `tu`, `tú` and `você`, for pupils
/// and for teachers (French: `vous` for teachers). Portuguese is that of Brazil, which the choice of the language says.

import {expect, test} from "vitest"
import {languages} from "../../src/words/language_choice.ts"
import {type Translation, translatedTexts} from "./translated_texts.ts"

/// The word for an idea, and those that stood for it as well, or that belong to another country or register.
interface Entry {
  readonly idea: string
  readonly word: string
  readonly not: RegExp
  /// Where the other words mean something else, the files to look at.
  readonly files?: RegExp
}

const lessons = /^examples/
const why = /why\.ts$/

const glossary: Readonly<Record<Translation, readonly Entry[]>> = {
  de: [
    {idea: "bumper", word: "Stoßstange", not: /Stoßfänger|(der|einen|den) Bumper/},
    {idea: "memory", word: "Erinnerung", not: /Gedächtnis/},
    {idea: "floor sensor", word: "Bodensensor", not: /Abgrundsensor|Klippensensor/},
    {idea: "button of the robot", word: "Knopf", not: /Button \d|Tasten? (des Roboters|\d)/},
    {idea: "button of the robot", word: "Knopf", not: /Taste(?!nfeld)/, files: lessons},
    {idea: "compiler", word: "Compiler", not: /Übersetzer/},
    {idea: "to send a value", word: "senden", not: /schick/, files: why},
    {idea: "the paper", word: "Artikel", not: /aus der Arbeit/},
    {idea: "a robot drives", word: "fahren", not: /\bLäuft er\b|Er läuft/, files: lessons},
    {idea: "teachers and pupils", word: "du", not: /\p{L}n Sie\b/u},
  ],
  fr: [
    {idea: "teacher, for pupils", word: "prof", not: /professeur/, files: /classroom\.ts$/},
    {
      idea: "command to the robot",
      word: "ordre",
      not: /[Cc]ommande/,
      files: /(lesson_editor|why|page|diagram)\.ts$|^docs\/fr\/(tutorial|why|ideas)/,
    },
    {idea: "run", word: "exécution", not: /trajet|les deux essais/, files: lessons},
    {idea: "empty place", word: "emplacement vide", not: /place vide/},
    {idea: "sensor", word: "capteur", not: /deux sens\b/},
    {idea: "Memory", word: "un Memory", not: /une (seule )?[`‘]?Memory/},
    {idea: "tick", word: "rythme", not: /battement/},
    {idea: "event", word: "événement", not: /[Éé]vènement/},
    {idea: "sign before a type", word: "deux fois deux-points", not: /deux fois deux points/},
    {idea: "to run a program", word: "tourner, s’exécuter", not: /programmes? marche|fonctions marchent/},
    {idea: "diagram", word: "schéma", not: /[Dd]iagramme/},
  ],
  es: [
    {idea: "computer", word: "ordenador", not: /computador/},
    {idea: "teacher, for pupils", word: "profe", not: /[Tt]u profesor/},
    {
      idea: "command to the robot",
      word: "comando",
      not: /[Óó]rdenes|[Uu]na orden\b/,
      files: /(lesson_editor|why|page|diagram)\.ts$|^docs\/es\/(tutorial|why|ideas)/,
    },
    {
      idea: "what a function takes",
      word: "acepta",
      not: /(función|que|no|Una|Esto) tom[ae]n?\b(?! (su|este))/,
      files: /^(docs|examples)|sentences\.json$/,
    },
    {
      idea: "goal of a room",
      word: "objetivo",
      not: /\b[Mm]eta\b/,
      files: /(room_tests|lessons|classroom)\.ts$/,
    },
    {idea: "sensor", word: "sensor", not: /dos sentidos/},
    {idea: "Memory", word: "un Memory", not: /una (sola )?[`‘]?Memory/},
    {
      idea: "what a task takes",
      word: "acepta",
      not: /’ recibe (aquí )?(metros|grados|segundos|radianes|una longitud|un texto)/,
    },
    {
      idea: "to run a program",
      word: "ejecutarse",
      not: /mientras (el programa funciona|funciona el programa)|corre el programa|pueden funcionar a la vez/,
    },
    {idea: "bump", word: "choque", not: /\b[Gg]olpes?\b/, files: /^(docs|examples)/},
    {idea: "teacher’s board", word: "panel", not: /[Tt]ablero/},
    {idea: "terminal", word: "la terminal", not: /\b(un|el|del|al) terminal\b/},
    {idea: "hole in the floor", word: "agujero", not: /un choque y un hueco/},
    {idea: "report of the robot", word: "informe", not: /cada aviso/},
    {idea: "teachers and pupils", word: "tú", not: /\b(Libere|Pruebe|Elija|Escriba|Haga|Pulse)\b/},
  ],
  pt: [
    {
      idea: "words of Portugal",
      word: "arquivo, tela, usuário, pen drive, baixar",
      not: /ficheiro|ecrã|utilizador|telemóvel|\bpen\b(?! drive)|descarreg|arranque|cá estão|tudo o resto/,
    },
    {idea: "what is going on", word: "está criando", not: /est(á|ão) a \p{L}+[aei]r\b/u},
    {idea: "to drive a robot", word: "dirigir", not: /[Cc]onduz/},
    {idea: "teacher’s board", word: "painel", not: /\bo quadro diz/},
    {idea: "tick", word: "ciclo", not: /batidas? do relógio/},
    {idea: "Memory and Velocity", word: "uma Memory, uma Velocity", not: /\bum [`‘]?(Memory|Velocity)/},
    {
      idea: "goal of a room",
      word: "meta",
      not: /[Oo]bjetivo/,
      files: /^languages\/pt\/(page|blocks|sentences)/,
    },
    {
      idea: "to turn",
      word: "girar",
      not: /\b([Vv]ire|[Vv]ira|virada)\b/,
      files: /(blocks|tasks|worksheets|welcome)\.ts$|^docs\/pt\/(?!study)/,
    },
    {
      idea: "pressed bumper",
      word: "pressionado",
      not: /apertado/,
      files: /^(docs|examples)|^languages\/pt\/page/,
    },
    {
      idea: "to run a program",
      word: "executar, ser executado",
      not: /rodando|rodava|não roda\b|Rodar|programa rod|(função|el[ae]) (não )?execut(a|ou)\b|programa executa\b(?!:)/,
    },
    {idea: "sensor", word: "sensor", not: /dois sentidos/},
  ],
}

const cases = (Object.keys(glossary) as Translation[]).flatMap(tag =>
  glossary[tag].map(entry => ({tag, ...entry})),
)

test.each(cases)("$tag: $idea is “$word”", ({tag, not, files = /./}) => {
  const other = translatedTexts(tag).filter(({file, text}) => files.test(file) && not.test(text))
  expect(other).toEqual([])
})

test("Portuguese is that of Brazil, and says so where the language is chosen", () => {
  expect(languages.pt).toBe("Português (Brasil)")
})

// The texts of commands are written for terminals, whose encodings and fonts may lack these characters.
const french = translatedTexts("fr").filter(({file}) => !file.includes("/help/"))

test.each([
  ["’ between letters", /\p{L}'\p{L}/u],
  [
    "a narrow space that does not break before ; ? » and after «",
    /\p{L}[ \u00A0]?[;?»](?= \p{L}|["`]|$)|«[^\u202F]/u,
  ],
  ["a narrow space that does not break before !", /\p{L}[ \u00A0]!(?!\[)/u],
  [
    "a space that does not break before :, which is no operator of Haskell",
    /\p{L}[ \u202F]:(?= (?!xs|others)\p{L}{2})/u,
  ],
])("French has %s", (_, wrong) => {
  const wrongs = french.filter(({text}) => wrong.test(text.replaceAll(/`[^`\n]*`(?=[^{]*$)/g, "`")))
  expect(wrongs).toEqual([])
})

test("German quotes are „ and “", () => {
  const others = translatedTexts("de").filter(({file}) => file.startsWith("docs/"))
  expect(others.filter(({text}) => /\p{L}"|”/u.test(text.replaceAll(/`[^`]*`|<[^>]*>/g, "")))).toEqual([])
})
