/// What is said about types, refusals, names, files and unfinished programs in German.

import type {Words} from "../../../codegen/src/words/index.ts"
import {robot} from "./robot.generated.ts"

export const sentences: Pick<
  Words,
  "conflicts" | "types" | "fits" | "network" | "renaming" | "projects" | "program" | "nouns" | "abilities"
> = {
  conflicts: {
    bothSet: (loser, winner, what) =>
      `\`${loser}\` und \`${winner}\` stellen beide ${what} ein, und \`${winner}\` gewinnt immer.`,
    waysOut: "Sag mit dem Block `zuerst … für 1 s, sonst …` (`priority`), welche Vorrang hat.",
    goesFirst: loser => `${loser} vorlassen, 1 s lang`,
    addsUp: (one, other) => `Zusammenzählen, was ${one} und ${other} wollen`,
  },
  types: {
    something: "irgendetwas",
    text: "Text",
    theEmptyValue: "der leere Wert ()",
    a: type => `etwas vom Typ ${type}`,
    somethingOfAnyType: "etwas von beliebigem Typ",
    aFunction: "eine Funktion",
    somethingWithValues: "etwas, worin Werte sind, etwa eine Liste",
    aList: "eine Liste",
    together: length => (length === 2 ? "ein Paar" : `eine Gruppe von ${length} Dingen`),
    aNumberWithAPoint: "eine Kommazahl",
    doWhatAsks: name => `zu ${name} gehören`,
    hereGoes: (wanted, what, found) => `Hierher gehört ${wanted}, aber ${what} ist ${found}.`,
    putSomethingElseHereOrChangeWhat: "Setze etwas anderes ein, oder ändere, was darum herum steht.",
    cannot: (what, ability) => `${what} kann ${not(ability)}.`,
    aNumberIsNoCommand: "Eine Zahl ist kein Befehl für den Roboter.",
    putAVelocityHere: "Setz hier `Velocity` ein, mit der Zahl darin.",
    useAnotherBlock: "Nimm hier einen anderen Block.",
    hasNoMeaning: what => `${what} bedeutet hier nichts.`,
    aNameIsKnownOnlyInside:
      "Ein Name ist nur in der Funktion bekannt, die ihn vergibt. Prüfe die Schreibweise oder lege ihn fest.",
    haskellItselfHasAAlready: name => `Haskell selbst hat schon ein \`${name}\`.`,
    giveThisOneAnotherName: "Gib diesem einen anderen Namen.",
    isGivenToTwoThings: name => `\`${name}\` heißen hier zwei Dinge.`,
    giveOneOfThemAnotherName: "Gib einem davon einen anderen Namen.",
    isNoPartOf: (name, of) => `\`${name}\` ist kein Teil von \`${of}\`.`,
    onlyNamesGoHere: of => `Hierher gehört nur, was \`${of}\` verlangt, jedes mit seinem Namen.`,
    takeItOutOfThisBlock: "Nimm es aus diesem Block heraus.",
    belongsTwice: (name, of) => `Hier steht zweimal, wie \`${name}\` zu \`${of}\` gehört.`,
    takeOneOfThemAway: "Nimm eins davon weg.",
    getsMoreInputsThanItTakes: what => `${what} bekommt mehr Eingaben, als es nimmt.`,
    takeTheLastOnesAway: "Nimm die letzten weg.",
    hasPartsAndHereAre: (name, wanted, found) => `${name} hat ${wanted} Teile, und hier sind ${found}.`,
    takeAFreshBlockFromTheToolbox: "Nimm einen neuen Block aus dem Werkzeugkasten.",
    nothingSaysWhatOneOfTheInputs: "Nichts sagt, was eine der Eingaben einer Funktion hier ist.",
    putAPatternLikeBumperInto: "Setze ein Muster wie Bumper ein, oder schreib den Typ der Funktion hin.",
    nothingSaysWhatAFunctionHereSends: "Nichts sagt, was eine Funktion hier sendet.",
    letItSendSomethingDefiniteOrWrite:
      "Lass sie etwas Bestimmtes senden, oder schreib den Typ der Funktion hin.",
    nothingSaysWhatTypeHas: what => `Nichts sagt, welchen Typ ${what} hat.`,
    useAValueOfADefiniteType: "Nimm einen Wert von bestimmtem Typ, oder schreib den Typ an die Definition.",
    theTypeOfThisDefinitionPromisesToo: ability =>
      `Der Typ dieser Definition verspricht zu viel: Nicht alles kann ${ability}.`,
    addToItsType: (name, type) => `Schreib ${name} ${type} zu ihrem Typ dazu.`,
    isNotAType: text => `„${text}“ ist kein Typ.`,
    writeItLikeVelocityMaybeSound: "Schreib ihn wie Velocity -> Maybe Sound.",
    thereIsNoType: name => `Es gibt keinen Typ ${name}.`,
    checkItsSpellingOrDefine: "Prüfe die Schreibweise oder lege ihn fest.",
    thereIsNoClass: name => `Es gibt keine Klasse ${name}.`,
    takesOtherArguments: name => `Hinter dem Typ ${name} stehen zu wenige oder zu viele Typen.`,
    writeItLikeMaybeInt: "Schreib ihn mit allen Teilen, wie Maybe Int.",
    needsAnotherClass: (of, name, wanted) => `${of} kann ${name} nur zusammen mit ${wanted} ableiten.`,
    deriveThatToo: wanted => `Füge ${wanted} zu dem hinzu, was abgeleitet wird.`,
    hasOnlyAType: name => `\`${name}\` hat einen Typ, aber nirgends steht, was es ist.`,
    addAnEquationFor: name =>
      `Schreib darunter eine Gleichung, die mit ${name} beginnt, oder nimm den Typ weg.`,
    differentNumbersOfInputs: "Die Gleichungen dieser Funktion haben verschieden viele Eingaben.",
    giveEachEquationTheSame: "Gib jeder Gleichung gleich viele Eingaben.",
    aDoneEndsATask: "Ein Done beendet eine Aufgabe, und das hier ist keine.",
    thisDoneDoesNotCarryWhat: "Dieses Done trägt nicht das, womit seine Aufgabe endet.",
    putItIntoTheFunctions: "Setze es in die Funktionen einer Aufgabe.",
    giveDoneTheSameKindOfValue: "Gib Done überall in der Aufgabe die gleiche Art von Wert.",
  },
  fits: {
    thisBlockIsGone: "Diesen Block gibt es nicht mehr.",
    aBlockCannotGoInsideItself: "Ein Block passt nicht in sich selbst.",
    rosyDoesNotKnowThisKind: "Diese Art von Block kennt Rosy nicht.",
    hereGoes: (wanted, makes) => `Hierher gehört ${wanted}, und dieser Block ${makes}.`,
    places: {
      expression: "ein Wert",
      pattern: "ein Name oder ein Muster",
      step: "ein Schritt einer Aufgabe",
      definition: "eine Definition",
    },
    makes: {
      expression: "macht einen Wert",
      pattern: "ist ein Muster für Eingaben",
      step: "ist ein Schritt einer Aufgabe",
      definition: "ist eine Definition",
      top: "steht für sich allein",
    },
    nothingCanBeJoined: "Hier kann man nichts anfügen.",
    onlyGhcKnows: name => `Nur der Compiler kennt den Typ von \`${name}\` und weiß deshalb, ob das passt.`,
    onlyGhcKnowsTheTypes: "Nur der Compiler kennt die Typen hier und weiß deshalb, ob das passt.",
    onlyGhcKnowsTheClass: (type, of) =>
      `Nur der Compiler weiß, ob \`${type}\` zu \`${of}\` gehört und ob das deshalb passt.`,
    doesNotGo: name => `${name} passt nicht hierher, wegen der Blöcke darum herum.`,
    isKnownOnlyInsideTheFunction: name =>
      `\`${name}\` ist nur in der Funktion bekannt, die den Namen vergibt, und passt deshalb nicht hierher.`,
    isKnownOnlyInAPart: name =>
      `\`${name}\` ist nur in dem Teil der Funktion bekannt, der den Namen vergibt, und passt deshalb nicht hierher.`,
    nothingIsCalled: name => `Nichts in diesem Programm heißt \`${name}\`, darum passt es nicht hierher.`,
    thisSocketWants: (w, name, f) => `Hierher gehört ${w}, und ${name} ist ${f}.`,
    turnsItInto: fn => `\`${fn}\` macht das eine aus dem anderen.`,
    thenThereWouldBeWhereMustBe: (found, wanted) => `Dann stünde dort ${found}, wo ${wanted} stehen muss.`,
    whatGoesHereMust: (ability, name, found) =>
      `Hierher passt nur, was ${ability} kann, und ${name} ist ${found}.`,
    cannot: (what, ability) => `${what} kann ${not(ability)}.`,
    aNumberIsNoCommand: "Eine Zahl ist kein Befehl; setz hier `Velocity` ein, mit der Zahl darin.",
    thenSomethingWouldGetMoreInputsThan: "Dann bekäme etwas mehr Eingaben, als es nimmt.",
    hasPartsNot: (name, wanted, found) => `${name} hat ${wanted} Teile, nicht ${found}.`,
    theTypeOfThisDefinitionPromisesMore:
      "Der Typ dieser Definition verspricht mehr, als dieser Block halten kann.",
    thisBlock: "dieser Block",
  },
  network: {
    noSuchFunction: name =>
      `\`${name}\` ist keine Funktion, die hier geändert werden kann. Ändere sie im Text.`,
    nameTaken: name => `Es gibt schon etwas mit dem Namen \`${name}\`. Wähle einen anderen Namen.`,
    notAName: name =>
      name === ""
        ? "Es braucht zuerst einen Namen."
        : `\`${name}\` kann hier kein Name sein. Ein Name ist ein Wort, das klein anfängt.`,
    notATypeName: name =>
      name === ""
        ? "Es braucht zuerst einen Namen."
        : `\`${name}\` kann nicht der Name eines Ereignisses, Typs oder Werts sein. Er ist ein Wort, das groß anfängt.`,
    noSimulate: "Das Programm sagt nicht mit `simulate`, was läuft. Deshalb kann dort nichts dazukommen.",
    typeUnknown: name => `Der Typ von \`${name}\` ist noch nicht klar. Schreibe zuerst den Typ auf.`,
    alreadyTakes: (name, type) => `\`${name}\` bekommt schon \`${type}\`.`,
    alreadySends: (name, type) => `\`${name}\` sendet schon \`${type}\`.`,
    alreadyRuns: name => `\`simulate\` führt \`${name}\` schon aus.`,
    doesNotRun: name => `\`simulate\` führt \`${name}\` nicht unter diesem Namen aus.`,
    takesNoEvent: name =>
      `\`${name}\` bekommt kein Ereignis, zu dem das neue eine Alternative sein kann. Lass es beide bekommen.`,
    takesTooMuch: name => `\`${name}\` bekommt schon neun Dinge. Mehr geht nicht.`,
    tellsApart: (name, type) =>
      `Fälle von \`${name}\` hängen von \`${type}\` ab. Entferne zuerst diese Fälle in den Blöcken.`,
    doesNotTake: (name, type) => `\`${name}\` bekommt \`${type}\` nicht für sich allein.`,
    doesNotSend: (name, type) => `\`${name}\` sendet \`${type}\` nicht.`,
    computesTogether: (name, type) =>
      `\`${name}\` berechnet \`${type}\` zusammen mit anderem, was es sendet. Trenne beides zuerst in den Blöcken.`,
    usedElsewhere: name => `Eine andere Definition benutzt \`${name}\`. Ändere zuerst diese.`,
    unfinished: names => `Im Text von \`${names}\` ist etwas unfertig. Schreibe es zuerst fertig.`,
    unfinishedText:
      "Das ist noch kein fertiges Haskell. Sieh dir Klammern, Anführungszeichen und Einrückung an.",
    noSuchStep: "Das ist kein Schritt, der hier geändert werden kann. Ändere ihn im Text.",
    onlyStep:
      "Das ist hier der einzige Schritt. Füge zuerst einen anderen hinzu, oder lösche, was darum herum steht.",
    insideItself: "Ein Schritt kann nicht in sich selbst stehen.",
    otherChain: "So lassen sich nur Schritte derselben Aufgabe verbinden. Verschiebe zuerst einen.",
    notComposed: "Das ist keine Schleife, und nichts läuft hier nebeneinander. Es gibt nichts aufzulösen.",
  },
  renaming: {
    thisBlockIsGone: "Diesen Block gibt es nicht mehr.",
    thisDefinitionIsBroken: "Bring diese Definition erst in Ordnung. Dann lassen sich ihre Namen ändern.",
    somethingIsUnfinished:
      "Etwas im Programm ist noch nicht fertig. Bring es erst in Ordnung, damit keine Stelle vergessen wird.",
    isOneOfHaskellsOwnWords: name => `„${name}“ ist eines von Haskells eigenen Wörtern.`,
    aNameIsOneWordThatStarts: "Ein Name ist ein einziges Wort und fängt mit einem kleinen Buchstaben an.",
    alreadyMeansSomethingElseWhereThisName: name =>
      `\`${name}\` bedeutet schon etwas anderes, wo dieser Name benutzt wird.`,
    thereIsAnotherDefinitionCalled: name => `Es gibt schon eine andere Definition namens \`${name}\`.`,
    haskellItselfHasAAlready: name => `Haskell selbst hat schon ein \`${name}\`.`,
    thereIsAnotherAlready: name => `Es gibt schon ein anderes \`${name}\`.`,
    isNotOfThisProgramSo: old => `\`${old}\` gehört nicht zu diesem Programm und behält seinen Namen.`,
    aTypeIsRenamedInItsBlock: "Ein Typ wird in seinem Block umbenannt und überall, wo er vorkommt.",
    isAlsoTheNameOfAPart: name =>
      `${name} steht allein in geschweiften Klammern, für einen Teil und seinen Wert. Schreibe dort zuerst ${name} = ${name}.`,
    cannotBeRenamedFrom: old => `\`${old}\` kann von hier aus nicht umbenannt werden.`,
    thisNameIsOneWordThatStarts:
      "Dieser Name ist ein einziges Wort und fängt mit einem großen Buchstaben an.",
  },
  projects: {
    thisFileIsNotAWholeRosy: "Diese Datei ist kein ganzes Rosy-Projekt.",
    itMayHaveBeenCutOffOpen:
      "Vielleicht ist sie abgeschnitten. Öffne eine Kopie, die ganz gespeichert wurde.",
    thisFileIsNotARosyProject: "Diese Datei ist kein Rosy-Projekt.",
    aProjectIsAFileThatRosy: "Ein Projekt ist eine Datei, die Rosy gespeichert hat. Sie endet auf .rosy.",
    atRosyExpectedFound: (version, it) => `Bei rosy: erwartet ${version}, gefunden ${it}.`,
    thisProjectWasSavedByANewer: "Dieses Projekt wurde von einem neueren Rosy gespeichert.",
    itsVersionIsAndThisRosyReads: (rosy, version) =>
      `Es hat die Version ${rosy}, und dieses Rosy liest bis ${version}. Hole dir ein neueres Rosy.`,
    theBlocksAreArrangedAnew:
      "Die Plätze der Blöcke in dieser Datei sind beschädigt. Das Programm ist vollständig; seine Blöcke werden neu geordnet.",
    someBlocksSaidSomethingElse:
      "Manche Blöcke in dieser Datei sagten etwas anderes als ihr Text. Es gilt der Text; die Blöcke sagen jetzt dasselbe.",
    theyAre: (names: string) => `Sieh nach bei: ${names}.`,
    thisProjectFileIsDamaged: "Diese Projektdatei ist beschädigt.",
  },
  program: {
    this: "das hier",
    thisBlockIsOfAKind: "Diese Art von Block kennt Rosy nicht.",
    thisBlockBelongsToNoFunctionSo: "Dieser Block gehört zu keiner Funktion und tut deshalb nichts.",
    itMayComeFromANewerVersion: "Vielleicht kommt er aus einer neueren Version.",
    putItIntoASocketOrThrow: "Setze ihn in einen Platz, oder wirf ihn weg.",
    somethingIsMissing: "Hier fehlt etwas.",
    andMore: (count: number) => `… und ${count.toLocaleString("de")} weitere`,
    moreLines: (count: number) =>
      `… und ${count.toLocaleString("de")} weitere ${count === 1 ? "Zeile" : "Zeilen"}. Ändere sie im Text.`,
    fillTheEmptySocket: socket => `Klick auf den leeren Platz, um zu sehen, was passt: ${socket}.`,
    thisBlockDoesNotBelong: "Dieser Block gehört nicht hierher.",
    takeItOutAndPutAnother: "Nimm ihn heraus und setze einen anderen ein.",
    aBlock: "ein Block",
    thisText: "dieser Text",
    thereAreTwoDefinitions: it => `Es gibt zwei Definitionen von \`${it}\`.`,
    giveOneOfThemAnotherName: "Gib einer davon einen anderen Namen.",
    theProgramDoesNotSayWhat: "Das Programm sagt nicht, was laufen soll.",
    addASimulateBlock: "Füge einen Block „simuliere“ hinzu.",
  },
  nouns: {
    ...robot.nouns,
    Double: "eine Zahl",
    Float: "eine Zahl",
    Int: "eine ganze Zahl",
    Integer: "eine ganze Zahl",
    Word: "eine ganze Zahl",
    Bool: "ein Ja oder Nein",
    Char: "ein Zeichen",
    Seconds: "eine Zeit in Sekunden",
    Ordering: "LT, EQ oder GT",
    Clock: "eine Uhrzeit",
    StdGen: "eine Quelle des Zufalls",
    Never: "etwas, was nie geschieht",
    TaskOptions: "eine Reihe von Angaben für eine Aufgabe",
    CallOptions: "eine Reihe von Angaben für einen Aufruf",
    Call: "ein Aufruf einer Aufgabe",
    IO: "ein ganzes Programm",
    Task: "eine Aufgabe",
    Priority: "ein Vorrang",
  },
  abilities: {
    Num: "eine Zahl sein",
    Fractional: "eine Kommazahl sein",
    Floating: "eine Kommazahl sein",
    RealFrac: "eine Kommazahl sein",
    Real: "eine Zahl sein",
    Integral: "eine ganze Zahl sein",
    Eq: "verglichen werden",
    Ord: "der Größe nach geordnet werden",
    Show: "als Text gezeigt werden",
    Enum: "durchgezählt werden",
    Random: "ausgelost werden",
    Sensor: "gespürt werden",
    Command: "an den Roboter gesendet werden",
    Controller: "auf dem Roboter laufen",
    Runnable: "auf dem Roboter laufen",
    Monad: "Schritt für Schritt getan werden",
    MonadPlus: "nichts sein",
    MonadFail: "nichts sein",
    Semigroup: "aneinandergefügt werden",
    Monoid: "aneinandergefügt werden",
    Traversable: "Ding für Ding durchgegangen werden",
    RandomGen: "eine Quelle des Zufalls sein",
    Read: "aus Text gelesen werden",
    Bounded: "einen kleinsten und einen größten Wert haben",
    RealFloat: "eine Kommazahl sein",
    Typeable: "gemerkt werden",
    Value: "gemerkt werden",
    Applicative: "Schritt für Schritt getan werden",
    Alternative: "nichts sein",
    Functor: "Werte enthalten",
    Foldable: "Ding für Ding durchgegangen werden",
    Default: "einen ersten Wert zum Merken haben",
  },
}

/// "eine Zahl sein" becomes "keine Zahl sein"; "verglichen werden" becomes "nicht verglichen werden".
function not(ability: string): string {
  if (/^eine?[nmr]? /.test(ability)) return `k${ability}`
  return ability.startsWith("Werte ") ? `keine ${ability}` : `nicht ${ability}`
}
